// Runs in the page: takes the planes of frames and sends them to the receiver, which writes the capture (receiver.mjs).
// Copy this file into a project of your own and call it as three.js and babylon.js beside it do.

/** Name of the raw format that an array from the GPU holds: its type says the bits, its length the channels. */
function rawFormat(values, pixels) {
  const channels = values.length / pixels;
  const known = {
    Uint16Array: { 1: 'R16F', 2: 'RG16F', 4: 'RGBA16F' },
    Float32Array: { 1: 'R32F', 2: 'RG32F', 4: 'RGBA32F' },
    Uint32Array: { 1: 'R32_UINT' },
    Uint8Array: { 4: 'RGBA8_UNORM' },
  };
  const format = known[values.constructor.name]?.[channels];
  if (!format) throw new Error(`no raw format for ${channels} channels of ${values.constructor.name}`);
  return format;
}

export class TaaCapture {
  /**
   * `manifest`: name, engine, like, conventions, size and framesPerSecond as in capture.json (manual, captures).
   * Rows that WebGL reads come bottom first, which is what `rows` of each plane says.
   */
  constructor(manifest) {
    this.manifest = { format: 1, ...manifest, planes: {}, frames: [] };
    this.sent = [];
  }

  /** Begins frame `number`; `facts`: jitter, view, projection, cut … as in capture.json; matrices are arrays of 16. */
  frame(number, facts) {
    this.number = number;
    this.manifest.frames.push({ number, ...facts });
  }

  /** One plane of the frame, as readPixels left it. */
  async plane(name, values) {
    const [width, height] = this.manifest.size;
    const raw = rawFormat(values, width * height);
    const file = `${name}.{frame:4}.raw`;
    this.manifest.planes[name] = { file, raw, size: [width, height], rows: 'bottomFirst' };
    const digits = String(this.number).padStart(4, '0');
    const answer = await fetch(`/planes/${name}.${digits}.raw`, { method: 'POST', body: values });
    if (!answer.ok) throw new Error(`${name} of frame ${this.number} was not written: ${await answer.text()}`);
  }

  /** Ends the capture: capture.json is written last, so that a folder with one is whole. */
  async close() {
    const answer = await fetch('/planes/capture.json', { method: 'POST', body: JSON.stringify(this.manifest, null, 1) });
    if (!answer.ok) throw new Error(`capture.json was not written: ${await answer.text()}`);
  }
}
