// A ball in flight: collects the rows of the library in a track, which is drawn while it still grows.
const SOUND_RATE = 24000;
const FORCES = ["weight", "buoyancy", "drag", "magnus", "knuckle", "nets", "load", "friction"];
const ROWS = [19, 9, 11, 10, 5 + SOUND_RATE / 4, 7, 3 + 3 * FORCES.length];
const KINDS = ["impact", "slide", "roll", "rest", "net", "goal", "leave", "squeezed", "enterZone", "exitZone"];

class Flown {
  constructor(number, colour, radius) {
    Object.assign(this, { number, colour, radius, events: [], keeper: [], sounds: [], squashes: [], forces: [], nets: new NetTrack([]), keys: [], track: null, isOver: false, unfolds: true, plain: true });
  }

  // The end of the track so far, s.
  get end() { return this.keys.length > 0 ? this.keys[this.keys.length - 1].t : 0; }

  take(numbers, nameOf) {
    const rows = Array.from(numbers);
    for (let i = 0; i < rows.length; i += ROWS[rows[i]]) {
      const row = rows.slice(i + 1, i + ROWS[rows[i]]);
      switch (rows[i]) {
        case 0:
          this.key({ t: row[0], p: row.slice(1, 4), before: row.slice(4, 7), v: row.slice(7, 10), spin: row.slice(10, 13), q: row.slice(13, 17), motion: row[17] });
          break;
        case 1:
          this.events.push({ kind: KINDS[row[0]], thing: row[1], surface: nameOf(row[1]), time: row[2], position: row.slice(3, 6), before: row[6], after: row[7] });
          break;
        case 2:
          this.keeper.push({ t: row[0], feet: row.slice(1, 4), shoulders: row.slice(4, 7), hands: row.slice(7, 10) });
          break;
        case 4:
          this.sounds.push({ t: row[0], loudness: row[1], brightness: row[2], brush: row[3], samples: Float32Array.from(row.slice(4)) });
          break;
        case 5:
          this.squashes.push({ t: row[0], along: row[1], across: row[2], axis: row.slice(3, 6) });
          break;
        case 6:
          this.forces.push({ t: row[0], of: row[1] ? Object.fromEntries(FORCES.map((name, i) => [name, row.slice(2 + 3 * i, 5 + 3 * i)])) : null });
          break;
        default:
          this.nets.take(row);
      }
    }
    this.track = new Track({ keys: this.keys });
  }

  // Adds a key. There is one key per instant; at an event, its velocities before and after differ.
  key(key) {
    const last = this.keys[this.keys.length - 1];
    if (last && key.t - last.t < 1e-9) {
      if (key.before.some((x, i) => x !== key.v[i])) this.keys[this.keys.length - 1] = { ...key, before: last.before };
      return;
    }
    this.keys.push(key);
  }

  keeperAt(t) {
    if (this.keeper.length === 0) return null;
    const i = clamp(Math.round(t / 0.01), 0, this.keeper.length - 1);
    return this.keeper[i];
  }

  // Returns the squash at a time: scales along and across an axis; null if the ball is round.
  squashAt(t) {
    const next = this.squashes.findIndex(s => s.t > t);
    if (next < 1) return null;
    const a = this.squashes[next - 1], b = this.squashes[next], s = (t - a.t) / (b.t - a.t);
    const along = a.along + s * (b.along - a.along);
    return along < 0.999 ? { along, across: a.across + s * (b.across - a.across), axis: b.axis } : null;
  }

  // Returns the forces at a time by name, in N; null where the step uses impulses.
  forcesAt(t) { return this.forces.findLast(f => f.t <= t + 1e-9)?.of ?? null; }

  first(...kinds) { return this.events.find(e => kinds.includes(e.kind)); }

  // Returns the result of the shot in a few words, as soon as it is clear.
  verdict(t) {
    const seen = this.events.filter(e => e.time <= t);
    const goal = seen.find(e => e.kind === "goal");
    const touched = name => seen.some(e => e.kind === "impact" && (!goal || e.time < goal.time) && name.test(e.surface));
    if (goal) return touched(/keeper|gloves/) ? "In off the keeper!" : touched(/post|bar/) ? "In off the woodwork!" : "GOAL!";
    if (touched(/keeper|gloves/)) return "Saved!";
    if (touched(/bar/)) return "Off the bar!";
    if (touched(/post/)) return "Off the post!";
    if (touched(/wall|head/)) return "Into the wall.";
    if (seen.some(e => e.kind === "net")) return "Side netting.";
    return this.isOver && t >= this.end - 0.02 || t > 3.5 ? "Wide." : "";
  }
}
