// Draws the pitch, goal, wall, ball and predicted path from the description of the scene.
import * as THREE from "three";

const FORCE_COLORS = { weight: 0xffffff, drag: 0xff4040, magnus: 0x40d040, knuckle: 0xff40ff, nets: 0x808080, load: 0x4060ff, friction: 0xffc020 };

export class Picture {
  constructor(game, width, height) {
    this.game = game;
    this.renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setSize(width, height);
    this.renderer.shadowMap.enabled = true;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(0x9cc9ee);
    this.camera = new THREE.PerspectiveCamera(34, width / height, 0.1, 300);
    this.camera.position.set(-0.4, 2.7, 7.5);
    this.camera.lookAt(0.7, 0.9, -14);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x4a7a3a, 1.6));
    const sun = new THREE.DirectionalLight(0xffffff, 2.2);
    sun.position.set(-12, 24, 6);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    Object.assign(sun.shadow.camera, { left: -16, right: 16, top: 16, bottom: -26, far: 80 });
    this.scene.add(sun);
    this.pitch();
    for (const shape of game.scene.shapes) this.shape(shape);
    this.wall = game.wall.map(() => this.add(new THREE.CapsuleGeometry(0.25, 1.3, 8, 16), 0xd7263d));
    this.ball = this.add(new THREE.SphereGeometry(game.scene.radius, 32, 20), 0xffffff, ballTexture());
    this.arrows = Object.entries(FORCE_COLORS).map(([name, color]) => {
      const arrow = new THREE.ArrowHelper(new THREE.Vector3(0, 1, 0), new THREE.Vector3(), 1, color, 0.12, 0.08);
      arrow.visible = false;
      this.scene.add(arrow);
      return [name, arrow];
    });
    this.ahead = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ color: 0xfff36b, size: 0.12 }));
    this.ahead.frustumCulled = false;
    this.scene.add(this.ahead);
  }

  add(geometry, color, map = null) {
    const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color, map, roughness: 0.7 }));
    mesh.castShadow = true;
    this.scene.add(mesh);
    return mesh;
  }

  pitch() {
    for (let i = 0; i < 14; i++) {
      const stripe = new THREE.Mesh(new THREE.PlaneGeometry(80, 5.5), new THREE.MeshStandardMaterial({ color: i % 2 ? 0x3f8f3a : 0x388233, roughness: 1 }));
      stripe.rotation.x = -Math.PI / 2;
      stripe.position.z = 27.5 - 5.5 * (i + 0.5) - 0.5;
      stripe.receiveShadow = true;
      this.scene.add(stripe);
    }
  }

  // Draws a shape. Posts are rods; nets are meshes between four corners; markings are lines.
  shape({ kind, lines, faces, radius }) {
    if (kind === "frame") {
      for (const [x, y, z, toX, toY, toZ] of lines) {
        const from = new THREE.Vector3(x, y, z), along = new THREE.Vector3(toX, toY, toZ).sub(from);
        const rod = this.add(new THREE.CylinderGeometry(radius, radius, along.length(), 16), 0xffffff);
        rod.position.copy(from).addScaledVector(along, 0.5);
        rod.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.clone().normalize());
      }
    } else if (kind === "net") {
      const [a, b, c, d] = [0, 3, 6, 9].map(at => new THREE.Vector3().fromArray(faces[0], at)), points = [];
      for (let i = 0; i <= 24; i++) {
        const s = i / 24, at = (from, to) => from.clone().lerp(to, s);
        points.push(at(a, b), at(d, c), at(a, d), at(b, c));
      }
      this.scene.add(new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points), new THREE.LineBasicMaterial({ color: 0xffffff, transparent: true, opacity: 0.45 })));
    } else if (kind === "marking") {
      for (const line of lines) {
        this.scene.add(new THREE.Line(new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(line, 3)), new THREE.LineBasicMaterial({ color: 0xffffff })));
      }
    }
  }

  // Draws the rows t, x, y, z of a look-ahead.
  path(rows) {
    const points = new Float32Array(rows.length / 4 * 3);
    for (let i = 0; i < rows.length / 4; i++) points.set(rows.subarray(4 * i + 1, 4 * i + 4), 3 * i);
    this.ahead.geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
  }

  // Draws an arrow for each force, 0.25 m per N; no arrows for null.
  forces(forces) {
    for (const [name, arrow] of this.arrows) {
      const force = new THREE.Vector3().fromArray(forces?.[name] ?? [0, 0, 0]), size = force.length();
      arrow.visible = size > 0.02;
      if (!arrow.visible) continue;
      arrow.position.fromArray(this.game.ball.position);
      arrow.setDirection(force.divideScalar(size));
      arrow.setLength(0.25 * size, 0.12, 0.08);
    }
  }

  draw() {
    const { ball, wall } = this.game;
    this.ball.position.fromArray(ball.position);
    this.ball.quaternion.fromArray(ball.orientation);
    this.wall.forEach((player, i) => player.position.fromArray(wall[i]));
    this.renderer.render(this.scene, this.camera);
  }
}

function ballTexture() {
  const canvas = Object.assign(document.createElement("canvas"), { width: 256, height: 128 }), pen = canvas.getContext("2d");
  pen.fillStyle = "#fff";
  pen.fillRect(0, 0, 256, 128);
  pen.fillStyle = "#20242c";
  for (const [x, y] of [[26, 42], [77, 42], [128, 42], [179, 42], [230, 42], [51, 86], [102, 86], [154, 86], [205, 86], [0, 86], [256, 86]]) {
    pen.beginPath();
    pen.arc(x, y, 13, 0, 2 * Math.PI);
    pen.fill();
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}
