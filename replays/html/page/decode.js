'use strict';
// Fulbito's replay viewer. Part 1: decodes the texts in the page to columns of numbers. All sizes are checked
// before memory is allocated, because the file may come from anyone.

const kLimits = { scenes: 5000, bodies: 1024, rows: 4e6, values: 2e7, bytes: 2.6e8 };

class BadReplay extends Error {}

function demand(good, text) {
  if (!good) throw new BadReplay(text);
}

const isCount = (value, most) => Number.isInteger(value) && value >= 0 && value <= most;

function readMeta() {
  const element = document.getElementById('meta');
  demand(element, 'The file is incomplete: the part that describes the replay is missing.');
  let meta;
  try {
    meta = JSON.parse(element.textContent);
  } catch {
    throw new BadReplay('The file is incomplete or damaged: the part that describes the replay cannot be read.');
  }
  demand(meta && meta.format === 1, 'This page does not support the format of the replay.');
  const { payload, scenes } = meta;
  demand(Array.isArray(scenes) && scenes.length > 0 && scenes.length <= kLimits.scenes && payload,
    'The replay is empty.');
  demand(isCount(payload.raw, kLimits.bytes) && isCount(payload.packed, kLimits.bytes), 'The replay is too large.');
  for (const scene of scenes) {
    demand(isCount(scene.rows, kLimits.rows) && isCount(scene.ticks, 1e9) && isCount(scene.bytes, payload.raw) &&
      Array.isArray(scene.bodies) && scene.bodies.length <= kLimits.bodies &&
      scene.rows * scene.bodies.length * 3 <= kLimits.values &&
      isCount(scene.commands.values, kLimits.values) && isCount(scene.drawings.count, kLimits.values) &&
      scene.rate > 0 && Array.isArray(scene.plays) && scene.plays.length > 0, 'The replay is too large or damaged.');
  }
  return meta;
}

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

function crc32(bytes) {
  const table = new Int32Array(256);
  for (let i = 0; i < 256; ++i) {
    let c = i;
    for (let k = 0; k < 8; ++k) c = c & 1 ? (c >>> 1) ^ 0xedb88320 : c >>> 1;
    table[i] = c;
  }
  let crc = -1;
  for (let i = 0; i < bytes.length; ++i) crc = table[(crc ^ bytes[i]) & 255] ^ (crc >>> 8);
  return ~crc >>> 0;
}

async function inflated(bytes, size) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  const reader = stream.getReader();
  const out = new Uint8Array(size);
  for (let used = 0;;) {
    const { done, value } = await reader.read();
    if (done) {
      demand(used === size, '');
      return out;
    }
    if (used + value.length > size) {
      reader.cancel();
      throw new BadReplay('');
    }
    out.set(value, used);
    used += value.length;
  }
}

async function readPayload(payload) {
  const element = document.getElementById('data');
  const text = element ? element.textContent.trim() : '';
  const damaged = 'The replay is incomplete or damaged; the positions cannot be shown. Ask for the file again.';
  demand(text.length === Math.ceil(payload.packed / 3) * 4, damaged);
  try {
    const bytes = await inflated(bytesOfBase64(text), payload.raw);
    demand(crc32(bytes) === payload.crc, '');
    return bytes;
  } catch {
    throw new BadReplay(damaged);
  }
}

/** Reads signed varints from the front of some bytes. Past the end they are 0, and `sound` returns false. */
class Varints {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }
  next() {
    let value = 0, scale = 1, byte;
    do {
      byte = this.bytes[this.at++];
      value += (byte & 127) * scale;
      scale *= 128;
    } while (byte > 127 && scale < 1e13);
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }
  sound() {
    return this.at === this.bytes.length;
  }
}

/** Undoes scene_columns.cpp. `first[row]` is true where a value does not continue the one before it. */
function unpackColumn(from, rows, first, step, to = new Float64Array(rows)) {
  let last = 0, change = 0;
  for (let r = 0; r < rows; ++r) {
    if (first[r]) change = 0;
    const value = last + change + from.next();
    change = first[r] ? 0 : value - last;
    last = value;
    to[r] = value * step;
  }
  return to;
}

function unpackPlain(from, count, step, to = new Float32Array(count)) {
  for (let i = 0, last = 0; i < count; ++i) to[i] = (last += from.next()) * step;
  return to;
}
