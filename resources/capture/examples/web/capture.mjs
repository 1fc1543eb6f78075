// node capture.mjs three|babylon FOLDER [--frames 8] [--size 480x270]: renders an example in headless Chromium and writes a
// capture of it. CHROMIUM names the browser, /usr/bin/chromium else.
import { parseArgs } from 'node:util';
import puppeteer from 'puppeteer-core';
import { startReceiver } from './receiver.mjs';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { frames: { type: 'string', default: '8' }, size: { type: 'string', default: '480x270' } },
});
const [engine, folder] = positionals;
const size = values.size.match(/^(\d+)x(\d+)$/);
if (!['three', 'babylon'].includes(engine) || !folder || !size) {
  console.error('usage: node capture.mjs three|babylon FOLDER [--frames 8] [--size 480x270]');
  process.exit(2);
}

const receiver = await startReceiver(folder);
// SwiftShader draws where there is no GPU.
const browser = await puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
  protocolTimeout: 600000,
});
let failed = false;
try {
  const page = await browser.newPage();
  page.on('console', (message) => console.error(`${engine}: ${message.text()}`));
  page.on('pageerror', (error) => { failed = true; console.error(`${engine}: ${error.message}`); });
  await page.goto(`${receiver.url}/${engine}.html?frames=${values.frames}&width=${size[1]}&height=${size[2]}`);
  await page.waitForFunction('window.captureEnded !== undefined', { timeout: 600000 });
  const ended = await page.evaluate('window.captureEnded');
  if (ended !== true) { failed = true; console.error(`${engine}: ${ended}`); }
} finally {
  await browser.close();
  receiver.close();
}
if (failed) process.exit(1);
console.log(`${folder}: ${values.frames} frames of ${engine}`);
