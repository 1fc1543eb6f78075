// Serves the page and the libraries to the browser, and writes what the page sends into the capture's folder.
import { createServer } from 'node:http';
import { mkdir, readFile, rename, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript' };
const planeName = /^[A-Za-z]+\.\d{4,}\.raw$|^capture\.json$/;

async function bodyOf(request) {
  const parts = [];
  for await (const part of request) parts.push(part);
  return Buffer.concat(parts);
}

/** Files are written beside their name and renamed: nobody sees half of one. */
async function writeWhole(file, bytes) {
  await writeFile(`${file}.part`, bytes);
  await rename(`${file}.part`, file);
}

async function answer(request, response, folder) {
  const name = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
  if (request.method === 'POST') {
    const file = path.basename(name);
    if (!planeName.test(file)) throw new Error(`"${file}" is no plane`);
    await writeWhole(path.join(folder, file), await bodyOf(request));
    return response.end('written');
  }
  const file = path.join(here, path.normalize(name));
  if (!file.startsWith(here)) throw new Error('outside of the examples');
  response.setHeader('Content-Type', types[path.extname(file)] ?? 'application/octet-stream');
  response.end(await readFile(file));
}

/** Resolves to { url, close }. */
export async function startReceiver(folder) {
  await mkdir(folder, { recursive: true });
  const server = createServer((request, response) => {
    answer(request, response, folder).catch((error) => {
      response.statusCode = 400;
      response.end(String(error.message));
    });
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { url: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}
