// The capsule in WebGL: one camera, one or two panes (reference and deformed), drawn when something changed.
import {
  AmbientLight, BackSide, BufferAttribute, BufferGeometry, Color, CylinderGeometry, DirectionalLight, Group,
  LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshPhongMaterial, OrthographicCamera, Quaternion, Raycaster,
  Scene, SphereGeometry, Vector2, Vector3, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {onResize} from './dom.js';

const UP = new Vector3(0, 1, 0); // of three's cylinders

// A rod from the origin's one side to the other.
function rod(radius) {
  const mesh = new Mesh(new CylinderGeometry(radius, radius, 1, 12), new MeshBasicMaterial());
  mesh.userData.turn = (direction, length) => {
    mesh.quaternion.copy(new Quaternion().setFromUnitVectors(UP, new Vector3(...direction).normalize()));
    mesh.scale.set(1, length, 1);
  };
  return mesh;
}

// A dot that shines faintly through the surface when it lies behind it.
function dot(radius) {
  const sphere = new SphereGeometry(radius, 20, 14), group = new Group();
  const front = new Mesh(sphere, new MeshBasicMaterial({color: '#e4002b'}));
  const behind = new Mesh(sphere, new MeshBasicMaterial({color: '#e4002b', transparent: true, opacity: 0.35, depthTest: false}));
  behind.renderOrder = 2;
  group.add(front, behind);
  return group;
}

// The surface a little blown up and seen from inside: its rim is the outline of the capsule.
function outlineMaterial() {
  const material = new MeshBasicMaterial({side: BackSide, color: '#000'});
  material.onBeforeCompile = shader => {
    shader.vertexShader = shader.vertexShader
      .replace('#include <begin_vertex>', 'vec3 transformed = position + 0.012 * normal;');
  };
  return material;
}

class Pane {
  constructor(surface, axes) {
    this.scene = new Scene();
    this.geometry = new BufferGeometry();
    this.attribute('position', surface.reference.position.slice());
    this.attribute('normal', surface.reference.normal.slice());
    this.attribute('color', new Float32Array(3 * surface.nVertices).fill(0.5));
    this.geometry.setIndex(new BufferAttribute(surface.triangles, 1));
    const material = new MeshPhongMaterial({
      vertexColors: true, shininess: 28, specular: new Color('#181818'),
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    });
    this.body = new Mesh(this.geometry, material);
    this.outline = new Mesh(this.geometry, outlineMaterial());
    const lines = new BufferGeometry();
    lines.setAttribute('position', this.geometry.getAttribute('position'));
    lines.setIndex(new BufferAttribute(surface.edges, 1));
    this.mesh = new LineSegments(lines, new LineBasicMaterial({color: '#000', transparent: true, opacity: 0.45}));
    this.mesh.visible = false;
    for (const object of [this.body, this.outline, this.mesh]) object.frustumCulled = false;
    this.axes = new Group();
    for (const axis of axes) this.axes.add(axis);
    this.dots = [];
    this.scene.add(this.body, this.outline, this.mesh, this.axes, new AmbientLight('#fff', 1.35));
    this.light = new DirectionalLight('#fff', 2.1);
    this.scene.add(this.light, this.light.target);
  }

  attribute(name, values) {
    this.geometry.setAttribute(name, new BufferAttribute(values, 3));
  }

  // A dot rides on the drawing point of each mark ({vertex, frame}).
  addDots(marks) {
    for (const {vertex, frame} of marks) {
      const object = dot(0.04);
      this.dots.push({vertex, frame, object});
      this.scene.add(object);
    }
  }

  showDots(frame) {
    for (const one of this.dots) one.object.visible = one.frame === undefined || one.frame === frame;
  }

  place(position, normal, center) {
    const target = this.geometry.getAttribute('position');
    for (let i = 0; i < position.length; i++) target.array[i] = position[i] - center[i % 3];
    this.geometry.getAttribute('normal').array.set(normal);
    target.needsUpdate = this.geometry.getAttribute('normal').needsUpdate = true;
    this.geometry.boundingSphere = null;
    for (const {vertex, object} of this.dots) object.position.copy(this.point(vertex));
  }

  paint(colors) {
    this.geometry.getAttribute('color').array.set(colors);
    this.geometry.getAttribute('color').needsUpdate = true;
  }

  point(vertex) {
    const p = this.geometry.getAttribute('position').array;
    return new Vector3(p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]);
  }

  // The light comes over the viewer's left shoulder.
  lightFrom(camera) {
    this.light.position.set(-0.55, 0.65, 1).applyQuaternion(camera.quaternion);
  }
}

export class Scene3d {
  // host: element to fill; throws where WebGL is missing.  onview: called after each drawing.
  constructor(host, surface, reach, onview) {
    this.host = host;
    this.reach = reach + 0.38; // room for axes and labels
    this.onview = onview;
    this.renderer = new WebGLRenderer({antialias: true, alpha: true, preserveDrawingBuffer: true});
    this.renderer.autoClear = false;
    this.canvas = this.renderer.domElement;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', 'the capsule');
    host.prepend(this.canvas);
    this.majorAxis = rod(0.014);
    this.vorticity = [rod(0.014), rod(0.014)];
    this.reference = new Pane(surface, [this.vorticity[0]]);
    this.deformed = new Pane(surface, [this.vorticity[1], this.majorAxis]);
    this.panes = [this.reference, this.deformed];
    this.camera = new OrthographicCamera();
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(0, -20, 0);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enablePan = false;
    this.controls.minZoom = 0.6;
    this.controls.maxZoom = 12;
    this.controls.addEventListener('change', () => this.draw());
    this.raycaster = new Raycaster();
    onResize(host, () => this.resize());
  }

  // Looks from `direction`, with z upward on the screen.
  lookFrom(direction) {
    this.camera.position.set(...direction).normalize().multiplyScalar(20);
    this.camera.zoom = 1;
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.draw();
  }

  // [[pane, {x, y, width, height} in CSS pixels from the top left]]
  layout() {
    const width = this.host.clientWidth, height = this.host.clientHeight;
    if (!this.showReference) return [[this.deformed, {x: 0, y: 0, width, height}]];
    return height > width
      ? [[this.reference, {x: 0, y: 0, width, height: height / 2}], [this.deformed, {x: 0, y: height / 2, width, height: height / 2}]]
      : [[this.reference, {x: 0, y: 0, width: width / 2, height}], [this.deformed, {x: width / 2, y: 0, width: width / 2, height}]];
  }

  resize() {
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(this.host.clientWidth, this.host.clientHeight);
    this.render();
  }

  draw() {
    this.due ??= requestAnimationFrame(() => {
      this.due = undefined;
      this.render();
    });
  }

  // The capsule fits into a pane of any proportions, at one scale for all panes of a size.
  fit({width, height}) {
    const scale = this.reach / Math.min(width, height);
    Object.assign(this.camera, {left: -scale * width, right: scale * width, top: scale * height, bottom: -scale * height, near: 0.1, far: 40});
    this.camera.updateProjectionMatrix();
  }

  render() {
    const total = this.host.clientHeight;
    if (!total) return;
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    for (const [pane, box] of this.layout()) {
      this.fit(box);
      this.camera.updateMatrixWorld();
      pane.lightFrom(this.camera);
      this.renderer.setViewport(box.x, total - box.y - box.height, box.width, box.height);
      this.renderer.setScissor(box.x, total - box.y - box.height, box.width, box.height);
      this.renderer.render(pane.scene, this.camera);
    }
    this.onview();
  }

  // Where a point of a pane lies on the host, in CSS pixels.
  project(pane, point) {
    const box = this.layout().find(([which]) => which === pane)?.[1];
    if (!box) return null;
    this.fit(box);
    const p = point.clone().project(this.camera);
    return {x: box.x + (0.5 + 0.5 * p.x) * box.width, y: box.y + (0.5 - 0.5 * p.y) * box.height};
  }

  // The pane and triangle corner nearest to a place on the host: {pane, vertex}, or null.
  pick(x, y) {
    for (const [pane, box] of this.layout()) {
      if (x < box.x || y < box.y || x >= box.x + box.width || y >= box.y + box.height) continue;
      this.fit(box);
      const at = new Vector2((2 * (x - box.x)) / box.width - 1, 1 - (2 * (y - box.y)) / box.height);
      this.raycaster.setFromCamera(at, this.camera);
      const hit = this.raycaster.intersectObject(pane.body)[0];
      if (!hit) return null;
      const {a, b, c} = hit.face;
      const vertex = [a, b, c].sort((p, q) => pane.point(p).distanceTo(hit.point) - pane.point(q).distanceTo(hit.point))[0];
      return {pane, vertex};
    }
    return null;
  }
}
