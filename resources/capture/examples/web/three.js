// Frames of three.js with its TRAANode: color, velocity, depth and what the engine's TAA makes of them.
import * as THREE from 'three/webgpu';
import { mrt, output, pass, texture, vec4, velocity } from 'three/tsl';
import { traa } from 'three/addons/tsl/display/TRAANode.js';
import { TaaCapture } from './taa-capture.js';

const wanted = new URLSearchParams(location.search);
const [frames, width, height] = ['frames', 'width', 'height'].map((name) => Number(wanted.get(name)));
const framesPerSecond = 30;

/** A floor with tiles, a ball that hops, a bar that spins, and a thin ring: something for each kind of edge. */
function makeScene() {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0.35, 0.5, 0.7);
  scene.add(new THREE.HemisphereLight(0xffffff, 0x444433, 1.5));
  const sun = new THREE.DirectionalLight(0xffffff, 2);
  sun.position.set(3, 5, 2);
  scene.add(sun);
  const tiles = new Uint8Array(64 * 64 * 4);
  for (let i = 0; i < 64 * 64; ++i) {
    const isLight = ((i % 64) >> 2 ^ (i >> 8)) & 1;
    tiles.set(isLight ? [200, 190, 170, 255] : [70, 60, 60, 255], 4 * i);
  }
  const map = new THREE.DataTexture(tiles, 64, 64);
  map.colorSpace = THREE.SRGBColorSpace;
  map.magFilter = THREE.LinearFilter;
  map.minFilter = THREE.LinearMipmapLinearFilter;
  map.generateMipmaps = true;
  map.needsUpdate = true;
  const add = (geometry, material) => scene.add(new THREE.Mesh(geometry, new THREE.MeshStandardMaterial(material))).children.at(-1);
  add(new THREE.PlaneGeometry(8, 8), { map }).rotation.x = -Math.PI / 2;
  const ball = add(new THREE.SphereGeometry(0.35, 32, 16), { color: 0xcc3322 });
  const bar = add(new THREE.BoxGeometry(1.6, 0.15, 0.15), { color: 0x2255cc });
  const ring = add(new THREE.TorusGeometry(0.6, 0.015, 8, 64), { color: 0xddcc33 });
  ring.position.set(-1, 0.9, -0.5);
  const pose = (seconds) => {
    ball.position.set(1.2 * Math.sin(2 * seconds), 0.35 + Math.abs(Math.sin(5 * seconds)), 0.6);
    bar.position.set(0.7, 0.8, -0.4);
    bar.rotation.z = 4 * seconds;
    ring.rotation.y = 1.5 * seconds;
  };
  return { scene, pose };
}

/** The jitter that TRAANode gives the camera in its next draw, px: what is seen at a pixel lies at + jitter. */
function nextJitter(node, isFirst) {
  if (isFirst) return [0, 0]; // the node sets itself up in the first draw, without jitter
  const halton = (index, base) => {
    let result = 0;
    for (let i = index, share = 1 / base; i > 0; i = Math.floor(i / base), share /= base) result += share * (i % base);
    return result;
  };
  return [2, 3].map((base) => halton(node._jitterIndex + 1, base) - 0.5);
}

const rowMajor = (matrix) => matrix.clone().transpose().toArray();

async function take() {
  const renderer = new THREE.WebGPURenderer({ forceWebGL: true, antialias: false });
  renderer.setPixelRatio(1);
  renderer.setSize(width, height);
  await renderer.init();
  const { scene, pose } = makeScene();
  const camera = new THREE.PerspectiveCamera(50, width / height, 0.1, 100);
  camera.position.set(1.5, 1.6, 3.4);
  camera.lookAt(0, 0.6, 0);

  const scenePass = pass(scene, camera);
  scenePass.setMRT(mrt({ output, velocity }));
  const color = scenePass.getTextureNode('output');
  const depth = scenePass.getTextureNode('depth');
  const taa = traa(color, depth, scenePass.getTextureNode('velocity'), camera);
  const pipeline = new THREE.RenderPipeline(renderer, taa);

  // A depth texture cannot be read in WebGL: it is drawn into one that can.
  const depthCopy = new THREE.RenderTarget(width, height, { type: THREE.FloatType, format: THREE.RedFormat, depthBuffer: false });
  const material = new THREE.NodeMaterial();
  material.fragmentNode = vec4(texture(scenePass.renderTarget.depthTexture).r, 0, 0, 1);
  const quad = new THREE.QuadMesh(material);

  const capture = new TaaCapture({
    name: 'three.js example', engine: `three.js r${THREE.REVISION}, TRAANode`, like: 'three', size: [width, height], framesPerSecond,
    conventions: { depth: { nearPlane: camera.near, farPlane: camera.far } },
  });
  const read = (target, index = 0) => renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height, index);
  for (let frame = 0; frame < frames; ++frame) {
    pose(frame / framesPerSecond);
    camera.updateMatrixWorld();
    const jitter = nextJitter(taa, frame === 0);
    const projection = rowMajor(camera.projectionMatrix);
    pipeline.render();
    capture.frame(frame, { jitter, view: rowMajor(camera.matrixWorldInverse), projection });
    renderer.setRenderTarget(depthCopy);
    quad.render(renderer);
    renderer.setRenderTarget(null);
    const names = scenePass.renderTarget.textures.map((each) => each.name);
    await capture.plane('color', await read(scenePass.renderTarget, names.indexOf('output')));
    await capture.plane('motion', await read(scenePass.renderTarget, names.indexOf('velocity')));
    await capture.plane('depth', await read(depthCopy));
    await capture.plane('output', await read(taa._resolveRenderTarget));
  }
  await capture.close();
}

take().then(() => { window.captureEnded = true; }, (error) => { window.captureEnded = String(error.stack ?? error); });
