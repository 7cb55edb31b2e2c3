// The curved surface for drawing: each quadratic triangle is cut into cuts * cuts flat ones, with positions,
// normals and area ratios of the exact quadratic map.

// Shape functions of the six nodes (corners 0 1 2, then edges 01, 12, 20) at (xi, eta), and their gradients.
function shapeFunctions(xi, eta) {
  const zeta = 1 - xi - eta;
  return {
    N: [zeta * (2 * zeta - 1), xi * (2 * xi - 1), eta * (2 * eta - 1), 4 * zeta * xi, 4 * xi * eta, 4 * eta * zeta],
    dxi: [1 - 4 * zeta, 4 * xi - 1, 0, 4 * (zeta - xi), 4 * eta, -4 * eta],
    deta: [1 - 4 * zeta, 0, 4 * eta - 1, -4 * xi, 4 * xi, 4 * (zeta - eta)],
  };
}

export function cutsFor(nElements) {
  return Math.max(1, Math.min(4, Math.floor(Math.sqrt(82000 / nElements))));
}

export class Surface {
  // element [nElements * 6], X [nNodes * 3] reference positions
  constructor(element, X, cuts) {
    this.element = element;
    this.nElements = element.length / 6;
    this.cuts = cuts;
    this.points = [];
    for (let j = 0; j <= cuts; j++)
      for (let i = 0; i <= cuts - j; i++) this.points.push({i, j, ...shapeFunctions(i / cuts, j / cuts)});
    this.number();
    this.triangulate();
    this.X = X;
    const {position, normal, area} = this.place(X);
    this.reference = {position, normal};
    this.referenceArea = area;
  }

  // A name of a drawing point that both elements at an edge give it.
  key(e, i, j) {
    const {cuts, element} = this, k = cuts - i - j, weight = [k, i, j];
    const held = [0, 1, 2].filter(corner => weight[corner] > 0);
    const node = corner => element[6 * e + corner];
    if (held.length === 3) return `${e}:${i}:${j}`;
    if (held.length === 1) return `${node(held[0])}`;
    const [a, b] = held.sort((p, q) => node(p) - node(q));
    return `${node(a)}-${node(b)}:${weight[b]}`;
  }

  number() {
    const numbers = new Map(), m = this.points.length;
    this.vertex = new Uint32Array(this.nElements * m); // of each element's drawing points
    for (let e = 0; e < this.nElements; e++)
      this.points.forEach(({i, j}, p) => {
        const key = this.key(e, i, j);
        if (!numbers.has(key)) numbers.set(key, numbers.size);
        this.vertex[e * m + p] = numbers.get(key);
      });
    this.nVertices = numbers.size;
    this.share = new Float32Array(this.nVertices); // 1 / number of elements at a drawing point
    for (const v of this.vertex) this.share[v]++;
    for (let v = 0; v < this.nVertices; v++) this.share[v] = 1 / this.share[v];
  }

  triangulate() {
    const {cuts} = this, m = this.points.length, corners = [], sides = [];
    const at = (i, j) => j * (cuts + 1) - (j * (j - 1)) / 2 + i;
    for (let j = 0; j < cuts; j++)
      for (let i = 0; i < cuts - j; i++) {
        corners.push(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j < cuts - 1) corners.push(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    for (let s = 0; s < cuts; s++)
      sides.push(at(s, 0), at(s + 1, 0), at(cuts - s, s), at(cuts - s - 1, s + 1), at(0, s), at(0, s + 1));
    const spread = local => Uint32Array.from({length: this.nElements * local.length},
      (_, n) => this.vertex[Math.floor(n / local.length) * m + local[n % local.length]]);
    this.triangles = spread(corners);
    this.edges = spread(sides);
  }

  // Positions, unit normals and area elements at the drawing points for nodal positions x.
  place(x) {
    const position = new Float32Array(3 * this.nVertices), normal = new Float32Array(3 * this.nVertices);
    const area = new Float32Array(this.nVertices), m = this.points.length;
    const y = new Float64Array(3), a = new Float64Array(3), b = new Float64Array(3);
    for (let e = 0; e < this.nElements; e++)
      for (let p = 0; p < m; p++) {
        const {N, dxi, deta} = this.points[p], v = this.vertex[e * m + p];
        y.fill(0), a.fill(0), b.fill(0);
        for (let k = 0; k < 6; k++) {
          const node = 3 * this.element[6 * e + k];
          for (let c = 0; c < 3; c++) {
            const value = x[node + c];
            y[c] += N[k] * value, a[c] += dxi[k] * value, b[c] += deta[k] * value;
          }
        }
        const n0 = a[1] * b[2] - a[2] * b[1], n1 = a[2] * b[0] - a[0] * b[2], n2 = a[0] * b[1] - a[1] * b[0];
        position.set(y, 3 * v);
        normal[3 * v] += n0, normal[3 * v + 1] += n1, normal[3 * v + 2] += n2;
        area[v] += this.share[v] * Math.hypot(n0, n1, n2);
      }
    for (let v = 0; v < this.nVertices; v++) {
      const length = Math.hypot(normal[3 * v], normal[3 * v + 1], normal[3 * v + 2]) || 1;
      for (let c = 0; c < 3; c++) normal[3 * v + c] /= length;
    }
    return {position, normal, area};
  }

  // A nodal field at the drawing points, kept within the range of each element's nodes.
  interpolate(values, components = 1) {
    const result = new Float32Array(components * this.nVertices), m = this.points.length;
    for (let e = 0; e < this.nElements; e++)
      for (let c = 0; c < components; c++) {
        const nodal = [0, 1, 2, 3, 4, 5].map(k => values[components * this.element[6 * e + k] + c]);
        const low = Math.min(...nodal), high = Math.max(...nodal);
        for (let p = 0; p < m; p++) {
          let value = 0;
          for (let k = 0; k < 6; k++) value += this.points[p].N[k] * nodal[k];
          result[components * this.vertex[e * m + p] + c] = Math.min(Math.max(value, low), high);
        }
      }
    return result;
  }

  // The drawing point nearest to a reference position.
  nearest(X) {
    let best = 0, least = Infinity;
    const p = this.reference.position;
    for (let v = 0; v < this.nVertices; v++) {
      const distance = (p[3 * v] - X[0]) ** 2 + (p[3 * v + 1] - X[1]) ** 2 + (p[3 * v + 2] - X[2]) ** 2;
      if (distance < least) [best, least] = [v, distance];
    }
    return best;
  }
}
