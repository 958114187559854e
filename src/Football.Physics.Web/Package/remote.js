// The counterpart of worker.js: objects with the same methods. Each method returns a promise.

const BALL = ["place", "launch", "restart", "kick", "step", "forces", "lookAhead", "lookAheadEnd", "lookAheadEvents", "impact", "impactSound", "squash", "keeper", "bulges", "hash", "save", "restore", "free"];

class Line {
  constructor(worker, PhysicsError) {
    this.worker = worker;
    this.PhysicsError = PhysicsError;
    this.calls = new Map();
    this.last = 0;
    worker.onmessage = ({ data }) => {
      const call = this.calls.get(data.id);
      this.calls.delete(data.id);
      if (data.error !== undefined) call.failed(new this.PhysicsError(data.error)); else call.done(data);
    };
    worker.onerror = event => {
      for (const call of this.calls.values()) call.failed(new Error(event.message || "The worker could not be started."));
      this.calls.clear();
    };
  }

  call(target, method, args, bodies) {
    return new Promise((done, failed) => {
      this.calls.set(++this.last, { done, failed });
      this.worker.postMessage({ id: this.last, target, method, args, bodies });
    });
  }
}

export class RemotePhysics {
  static async start(worker, options, PhysicsError) {
    const line = new Line(worker, PhysicsError), { value } = await line.call(0, "load", [options]);
    return Object.assign(new RemotePhysics(), value, { line });
  }

  async scene(description = {}) {
    const { value } = await this.line.call(0, "scene", [description]);
    return new RemoteScene(this.line, value);
  }

  async ball(description = {}) { return (await this.scene(description)).ball(); }

  async goldenHashes(every = 1) { return (await this.line.call(0, "goldenHashes", [every])).value; }

  terminate() { this.line.worker.terminate(); }
}

class RemoteScene {
  constructor(line, { bodies, ...about }) {
    Object.assign(this, about, { line, placed: new Map() });
    this.bodies = bodies.map((name, i) => ({
      name,
      place: (position, motion = {}) => { this.placed.set(i, [position, motion]); },
      withdraw: () => { this.placed.set(i, null); },
    }));
  }

  body(name) { return this.bodies.find(body => body.name === name); }

  async ball() { return new RemoteBall(this, (await this.line.call(this.id, "ball", [])).value); }

  async aim(request) { return (await this.line.call(this.id, "aim", [request])).value; }

  async free() { await this.line.call(this.id, "free", []); }
}

class RemoteBall {
  constructor(scene, { id, ...state }) {
    Object.assign(this, { scene, id }, state);
  }
}

// A call sends all placements since the last call, and receives the ball. So a frame sends one message in each direction.
for (const method of BALL) {
  RemoteBall.prototype[method] = async function (...args) {
    const { line, placed } = this.scene, bodies = placed.size > 0 ? [...placed] : undefined;
    placed.clear();
    const { value, state } = await line.call(this.id, method, args, bodies);
    Object.assign(this, state);
    return value;
  };
}
