// The motion: names and units from the model, values from the compressed columns.

const model = JSON.parse(document.getElementById("model").textContent);

/** Returns the bytes of base64 text. */
function bytesOf(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; k++) bytes[k] = letters.charCodeAt(k);
  return bytes;
}

/** Decompresses zlib data by the browser. */
async function inflate(bytes) {
  if (typeof DecompressionStream === "undefined") {
    throw new Error("This page needs a browser of 2023 or later (DecompressionStream).");
  }
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Returns the 16-bit values of a stored column: folded differences of some order, low and high bytes apart. */
function undifferenced(planes, stored, order) {
  const frames = model.frames;
  const low = stored * frames, high = (model.stored + stored) * frames;
  const values = new Uint16Array(frames);
  for (let k = 0; k < frames; k++) {
    const folded = planes[low + k] | (planes[high + k] << 8);
    values[k] = (folded >> 1) ^ -(folded & 1);
  }
  for (let pass = 0; pass < order; pass++) {
    let sum = 0;
    for (let k = 0; k < frames; k++) values[k] = sum = (sum + values[k]) & 0xffff;
  }
  return values;
}

class Motion {
  constructor(planes) {
    this.frames = model.frames;
    this.columns = model.columns;
    this.blocks = new Map(model.blocks.map(block => [block.name, block]));
    this.byName = new Map(model.columns.map((column, index) => [column.name, index]));
    const stored = new Map();
    const valuesOf = (index, order) => {
      if (!stored.has(index)) stored.set(index, undifferenced(planes, index, order));
      return stored.get(index);
    };
    this.readers = model.columns.map(({ values: it }, index) => this.reader(it, index, valuesOf));
    this.start = this.time(0);
    this.end = this.time(this.frames - 1);
  }

  /** Returns the function that gives a column's value in a frame. */
  reader(it, index, valuesOf) {
    if ("constant" in it) return () => it.constant;
    if ("stored" in it) {
      const values = valuesOf(it.stored, it.order), { low, step } = it;
      return frame => low + values[frame] * step;
    }
    if ("first" in it) return frame => it.first + frame * it.step;
    // At rest in its body.
    if ("position" in it) {
      return frame => add(this.position(it.of, frame), rotate(this.orientation(it.of, frame), it.offset))[it.position];
    }
    return frame => multiply(this.orientation(it.of, frame), it.turned)[it.orientation];
  }

  value(column, frame) { return this.readers[column](frame); }
  time(frame) { return this.readers[0](frame); }

  /** Returns the largest error of a column by its 16 bits; of points at rest in their body, that of the body's values. */
  uncertainty(column) {
    const it = this.columns[column].values;
    return "stored" in it ? it.step / 2 : 0;
  }

  /** Returns the last frame that is not later than a time. */
  frameAt(time) {
    let low = 0, high = this.frames - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.time(middle) <= time) low = middle; else high = middle - 1;
    }
    return low;
  }

  /** Returns the entries of a block at an item; undefined if the block is not recorded. */
  entries(name, item, count, frame) {
    const block = this.blocks.get(name);
    if (!block) return undefined;
    const first = block.first + item * count, out = new Array(count);
    for (let k = 0; k < count; k++) out[k] = this.readers[first + k](frame);
    return out;
  }

  position(point, frame) { return this.entries("position", point, 3, frame); }
  orientation(point, frame) { return unit(this.entries("orientation", point, 4, frame)); }
  force(point, frame) { return this.entries("force", point, 3, frame); }
  moment(point, frame) { return this.entries("moment", point, 3, frame); }
}
