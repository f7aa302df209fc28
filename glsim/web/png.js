/**
 * A picture's exact values.  A canvas would multiply them by alpha, and some browsers add noise to what a canvas reads.
 * @typedef {{width: number, height: number, data: Uint8ClampedArray<ArrayBuffer>, opaque: boolean}} Pixels data: RGBA
 */

/**
 * Decode a PNG of 8 bits a channel, RGB or RGBA, not interlaced: what page.py writes.  (PNG specification, 2003.)
 * @param {string} uri  data:image/png;base64,...
 * @returns {Promise<Pixels>}
 */
async function decodePNG(uri) {
  const text = atob(uri.slice(uri.indexOf(",") + 1));
  const file = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) file[i] = text.charCodeAt(i);
  const numbers = new DataView(file.buffer);
  const width = numbers.getUint32(16), height = numbers.getUint32(20); // IHDR is the first chunk
  const channels = file[25] === 6 ? 4 : 3;
  const compressed = [];
  for (let at = 8; at < file.length; ) { // a chunk: length, type, data, checksum
    const length = numbers.getUint32(at), type = String.fromCharCode(...file.subarray(at + 4, at + 8));
    if (type === "IDAT") compressed.push(file.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  const inflated = new Blob(compressed).stream().pipeThrough(new DecompressionStream("deflate"));
  const rows = new Uint8Array(await new Response(inflated).arrayBuffer());
  const stride = width * channels;
  const data = new Uint8ClampedArray(4 * width * height).fill(255);
  let opaque = true, above = new Uint8Array(stride);
  for (let y = 0; y < height; y++) {
    const filter = rows[y * (stride + 1)];
    const row = rows.subarray(y * (stride + 1) + 1, (y + 1) * (stride + 1));
    if (filter) unfilter(filter, row, above, channels);
    for (let x = 0, from = 0, to = 4 * y * width; x < width; x++, from += channels, to += 4) {
      data[to] = row[from], data[to + 1] = row[from + 1], data[to + 2] = row[from + 2];
      if (channels === 4) data[to + 3] = row[from + 3], opaque = opaque && row[from + 3] === 255;
    }
    above = row;
  }
  return { width, height, data, opaque };
}

/**
 * Undo a filter of a row in place: 1 Sub, 2 Up, 3 Average, 4 Paeth.
 * @param {number} filter @param {Uint8Array} row @param {Uint8Array} above @param {number} channels
 */
function unfilter(filter, row, above, channels) {
  for (let i = 0; i < row.length; i++) {
    const left = i < channels ? 0 : row[i - channels];
    const up = above[i];
    if (filter === 1) row[i] += left;
    else if (filter === 2) row[i] += up;
    else if (filter === 3) row[i] += (left + up) >> 1;
    else {
      const corner = i < channels ? 0 : above[i - channels];
      const toLeft = Math.abs(up - corner), toUp = Math.abs(left - corner), toCorner = Math.abs(left + up - 2 * corner);
      row[i] += toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
    }
  }
}
