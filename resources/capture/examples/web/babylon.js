// Frames of Babylon.js with its TAARenderingPipeline, history reprojected: color, velocity, view depth and its own output.
import { TaaCapture } from './taa-capture.js';

const wanted = new URLSearchParams(location.search);
const [frames, width, height] = ['frames', 'width', 'height'].map((name) => Number(wanted.get(name)));
const framesPerSecond = 30;
const { Color3, Constants, Vector3 } = BABYLON;

/** A floor with tiles, a ball that hops, a bar that spins, and a thin ring: something for each kind of edge. */
function makeScene(engine) {
  const scene = new BABYLON.Scene(engine);
  scene.clearColor = new BABYLON.Color4(0.35, 0.5, 0.7, 1);
  new BABYLON.HemisphericLight('sky', new Vector3(0.3, 1, 0.2), scene);
  const material = (name, color) => {
    const made = new BABYLON.StandardMaterial(name, scene);
    made.diffuseColor = color;
    made.specularColor = new Color3(0.1, 0.1, 0.1);
    return made;
  };
  const floor = BABYLON.MeshBuilder.CreateGround('floor', { width: 8, height: 8 }, scene);
  floor.material = material('tiles', new Color3(1, 1, 1));
  const tiles = new Uint8Array(64 * 64 * 4);
  for (let i = 0; i < 64 * 64; ++i) {
    const isLight = ((i % 64) >> 2 ^ (i >> 8)) & 1;
    tiles.set(isLight ? [200, 190, 170, 255] : [70, 60, 60, 255], 4 * i);
  }
  floor.material.diffuseTexture = BABYLON.RawTexture.CreateRGBATexture(tiles, 64, 64, scene, true, false,
    BABYLON.Texture.TRILINEAR_SAMPLINGMODE);
  const ball = BABYLON.MeshBuilder.CreateSphere('ball', { diameter: 0.7, segments: 24 }, scene);
  ball.material = material('red', new Color3(0.8, 0.2, 0.13));
  const bar = BABYLON.MeshBuilder.CreateBox('bar', { width: 1.6, height: 0.15, depth: 0.15 }, scene);
  bar.material = material('blue', new Color3(0.13, 0.33, 0.8));
  const ring = BABYLON.MeshBuilder.CreateTorus('ring', { diameter: 1.2, thickness: 0.03, tessellation: 64 }, scene);
  ring.material = material('yellow', new Color3(0.85, 0.8, 0.2));
  ring.position.set(-1, 0.9, 0.5);
  ring.rotation.x = Math.PI / 2;
  bar.position.set(0.7, 0.8, 0.4);
  const pose = (seconds) => {
    ball.position.set(1.2 * Math.sin(2 * seconds), 0.35 + Math.abs(Math.sin(5 * seconds)), -0.6);
    bar.rotation.z = 4 * seconds;
    ring.rotation.z = 1.5 * seconds;
  };
  const camera = new BABYLON.FreeCamera('camera', new Vector3(1.5, 1.6, -3.4), scene);
  camera.setTarget(new Vector3(0, 0.6, 0));
  camera.fov = 50 * Math.PI / 180;
  camera.minZ = 0.1;
  camera.maxZ = 100;
  return { scene, camera, pose };
}

/** What a plane's texture holds, as floats or halves. */
const read = (texture) => texture.readPixels(0, 0, null, true, true);

async function take() {
  const canvas = document.getElementById('canvas');
  canvas.width = width;
  canvas.height = height;
  const engine = new BABYLON.Engine(canvas, false, { preserveDrawingBuffer: true });
  engine.setSize(width, height);
  const { scene, camera, pose } = makeScene(engine);
  const pipeline = new BABYLON.TAARenderingPipeline('taa', scene, [camera], Constants.TEXTURETYPE_HALF_FLOAT);
  pipeline.disableOnCameraMove = false;
  pipeline.clampHistory = true;
  pipeline.reprojectHistory = true;
  // Distance along the camera's axis, 0 where nothing is; this pass knows nothing of the pipeline's jitter.
  const depth = scene.enableDepthRenderer(camera, false, true, Constants.TEXTURE_NEAREST_SAMPLINGMODE, true);
  const prePass = scene.prePassRenderer;
  await scene.whenReadyAsync();
  pose(0);
  scene.render(); // pipelines set themselves up in the first draw
  await scene.whenReadyAsync();

  const capture = new TaaCapture({
    name: 'Babylon.js example', engine: `Babylon.js ${BABYLON.Engine.Version}, TAARenderingPipeline`, like: 'babylon',
    size: [width, height], framesPerSecond,
    // The scene is left-handed, and the jitter is read before the draw that it is of.
    conventions: { depth: { scale: 1 }, jitter: { delay: 0 }, matrices: { forward: 'positiveZ' } },
  });
  for (let frame = 0; frame < frames; ++frame) {
    pose(frame / framesPerSecond);
    // Read before the draw: after it, it is that of the frame to come.
    const { x, y } = pipeline._taaThinPostProcess._taaMaterialManager.jitter;
    scene.render();
    capture.frame(frame, {
      jitter: [x, y], view: [...camera.getViewMatrix().asArray()], projection: [...camera.getProjectionMatrix().asArray()],
      cut: frame === 0,
    });
    const target = prePass.getRenderTarget();
    const plane = (kind) => read(target.textures[prePass.getIndex(kind)]);
    await capture.plane('color', await plane(Constants.PREPASS_COLOR_TEXTURE_TYPE));
    await capture.plane('motion', await plane(Constants.PREPASS_VELOCITY_LINEAR_TEXTURE_TYPE));
    await capture.plane('depth', await read(depth.getDepthMap()));
    const output = pipeline._pingpong ? pipeline._pong : pipeline._ping;
    await capture.plane('output', await engine._readTexturePixels(output.texture, width, height, -1, 0, null, true, true));
  }
  await capture.close();
}

take().then(() => { window.captureEnded = true; }, (error) => { window.captureEnded = String(error.stack ?? error); });
