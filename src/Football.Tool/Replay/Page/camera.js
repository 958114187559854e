// A camera that orbits its target.
const FIELD = 40 * Math.PI / 180;
const NEAR = 0.15;

// The minimum height of the camera above the ground, in m.
const LOWEST = 0.35;

class Camera {
  constructor() {
    this.target = [0, 0, 0];
    this.yaw = 0;
    this.pitch = 0.2;
    this.distance = 20;
    this.groundAt = () => 0;
    this.size(100, 100);
    this.update();
  }

  size(width, height) {
    this.width = width;
    this.height = height;
    this.focus = 0.5 * Math.min(height, 1.4 * width) / Math.tan(0.5 * FIELD);
  }

  update() {
    this.pitch = clamp(this.pitch, -1.55, 1.55);
    this.place();
    // Keep the camera above the grass, which may rise towards it.
    for (let i = 0; i < 4; i++) {
      const least = this.groundAt(this.eye[0], this.eye[2]) + LOWEST;
      if (this.eye[1] >= least - 1e-9) break;
      this.pitch = clamp(Math.asin(clamp((least - this.target[1]) / this.distance, -1, 1)), -1.55, 1.55);
      this.place();
    }
  }

  place() {
    const [sy, cy, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    this.forward = [-sy * cp, -sp, -cy * cp];
    this.right = [cy, 0, -sy];
    this.up = cross(this.right, this.forward);
    this.eye = sub(this.target, mul(this.distance, this.forward));
  }

  // Places the camera at a position, looking at a target.
  lookFrom(eye, target) {
    const d = sub(eye, target);
    this.target = target;
    this.distance = Math.max(0.3, len(d));
    this.yaw = Math.atan2(d[0], d[2]);
    this.pitch = Math.asin(clamp(d[1] / this.distance, -1, 1));
    this.update();
  }

  // A key that changes with the view.
  get key() {
    return [...this.eye, ...this.forward, this.width, this.height, this.focus].map(x => x.toFixed(4)).join(" ");
  }

  // Returns the point at which the ray through a pixel crosses a plane of constant z; null if it does not.
  onPlane(x, y, z) {
    const d = add(add(mul(this.focus, this.forward), mul(x - 0.5 * this.width, this.right)), mul(this.middle() - y, this.up));
    const s = (z - this.eye[2]) / d[2];
    return s > 0 ? add(this.eye, mul(s, d)) : null;
  }

  // Returns the components to the right, up and forward of the camera, in m.
  see(p) {
    const d = sub(p, this.eye);
    return [dot(d, this.right), dot(d, this.up), dot(d, this.forward)];
  }

  screen(c) {
    const s = this.focus / c[2];
    return [0.5 * this.width + s * c[0], this.middle() - s * c[1], s];
  }

  // The centre of the image is higher, because the bar at the bottom of the page hides a part of it.
  middle() { return 0.47 * this.height; }

  project(p) {
    const c = this.see(p);
    return c[2] > NEAR ? this.screen(c) : null;
  }

  // Returns the part of an open or closed line that is in front of the camera, on the screen.
  clipped(line, closed) {
    const seen = line.map(p => this.see(p));
    const out = [];
    const n = seen.length;
    for (let i = 0; i < n; i++) {
      const a = seen[i], b = seen[(i + 1) % n];
      if (a[2] > NEAR) out.push(this.screen(a));
      if (i + 1 === n && !closed) break;
      if ((a[2] > NEAR) !== (b[2] > NEAR)) out.push(this.screen(lerp(a, b, (NEAR - a[2]) / (b[2] - a[2]) + 1e-9)));
    }
    return out;
  }

  pixelsAt(p) {
    const c = this.see(p);
    return c[2] > NEAR ? this.focus / c[2] : 0;
  }

  // Moves the camera as close as possible with all points inside the margins, in pixels.
  fit(places, margin) {
    const low = [0, 1, 2].map(i => Math.min(...places.map(p => p[i])));
    const high = [0, 1, 2].map(i => Math.max(...places.map(p => p[i])));
    this.target = lerp(low, high, 0.5);
    const inside = () => places.every(p => {
      const s = this.project(p);
      return s && s[0] > margin.left && s[0] < this.width - margin.right && s[1] > margin.top && s[1] < this.height - margin.bottom;
    });
    // Adjust the distance and the target in turn.
    for (let round = 0; round < 20; round++) {
      if (round > 0) this.center(places, margin);
      let near = 1, far = 4000;
      for (let i = 0; i < 26; i++) {
        this.distance = Math.sqrt(near * far);
        this.update();
        if (inside()) far = this.distance; else near = this.distance;
      }
      this.distance = far;
      this.update();
    }
  }

  center(places, margin) {
    const seen = places.map(p => this.project(p)).filter(s => s);
    if (seen.length === 0) return;
    const x = 0.5 * (Math.min(...seen.map(s => s[0])) + Math.max(...seen.map(s => s[0])));
    const y = 0.5 * (Math.min(...seen.map(s => s[1])) + Math.max(...seen.map(s => s[1])));
    // Use the scale of the nearest point, which moves most on the screen.
    const s = 1 / Math.max(...seen.map(at => at[2]));
    this.target = add(this.target, add(
      mul(s * (x - 0.5 * (margin.left + this.width - margin.right)), this.right),
      mul(-s * (y - 0.5 * (margin.top + this.height - margin.bottom)), this.up)));
    this.update();
  }
}
