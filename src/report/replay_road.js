// The road of a replay: a plane with its friction patches and, where the road is no plane, a mesh beside the way.
const replayRoad = (function () {
    'use strict';

    const kGrid = 10;  // m between the strong lines

    // Asphalt grey where the tyres find their full grip, the lighter and bluer the less.
    function colourOf(friction) {
        return new THREE.Color('#565b61').lerp(new THREE.Color('#c4e6f8'), Math.min(1, Math.max(0, 1 - friction)));
    }

    // Lines every 2 m and every 10 m, so that speed can be seen.
    function gridTexture(anisotropy) {
        const canvas = document.createElement('canvas');
        canvas.width = canvas.height = 512;
        const pen = canvas.getContext('2d');
        pen.fillStyle = '#ffffff';
        pen.fillRect(0, 0, 512, 512);
        const line = (at, width, colour) => {
            pen.fillStyle = colour;
            pen.fillRect(at - width / 2, 0, width, 512);
            pen.fillRect(0, at - width / 2, 512, width);
        };
        for (let i = 1; i < 5; ++i) line(i * 102.4, 3, '#e2e2e2');
        for (const edge of [0, 512]) line(edge, 14, '#bdbdbd');
        const texture = new THREE.CanvasTexture(canvas);
        texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
        texture.anisotropy = anisotropy;
        return texture;
    }

    const kCone = 0.5;  // m high
    function cones(places) {
        const group = new THREE.Group();
        const shape = new THREE.ConeBufferGeometry(0.16, kCone, 16).rotateX(Math.PI / 2);
        const material = new THREE.MeshLambertMaterial({color: '#ff7a1a'});
        for (const [x, y, z] of places) {
            const cone = new THREE.Mesh(shape, material);
            cone.position.set(x, y, z + kCone / 2);
            cone.castShadow = true;
            group.add(cone);
        }
        return group;
    }

    function build(road, anisotropy) {
        const texture = gridTexture(anisotropy);
        const group = new THREE.Group();
        const planeAt = (x, y) => road.grade * x + road.bank * y;
        const decoded = road.mesh ? values.decode(road.mesh.heights, Uint16Array) : [];
        const lowered = road.mesh ? Math.max(0, -road.mesh.lowest) + 0.02 : 0;

        // Where patches overlap the last holds.
        function frictionAt(x, y) {
            let friction = road.friction;
            for (const patch of road.patches) {
                const [left, right, low, high] = patch.area;
                if (x >= left && x < right && y >= low && y < high) friction = patch.friction;
            }
            return friction;
        }

        function add(points, triangles, colours, layer) {
            const geometry = new THREE.BufferGeometry();
            const floats = (list, size) => new THREE.Float32BufferAttribute(list, size);
            geometry.setAttribute('position', floats(points, 3));
            geometry.setAttribute('color', floats(colours, 3));
            const places = [];
            for (let i = 0; i < points.length; i += 3) places.push(points[i] / kGrid, points[i + 1] / kGrid);
            geometry.setAttribute('uv', floats(places, 2));
            geometry.setIndex(triangles);
            geometry.computeVertexNormals();
            const material = new THREE.MeshLambertMaterial({
                map: texture, vertexColors: THREE.VertexColors,
                polygonOffset: true, polygonOffsetFactor: -layer, polygonOffsetUnits: -4 * layer
            });
            const mesh = new THREE.Mesh(geometry, material);
            mesh.receiveShadow = true;
            group.add(mesh);
        }

        function addRectangle([left, right, low, high], friction, layer) {
            const points = [], colours = [];
            for (const [x, y] of [[left, low], [right, low], [left, high], [right, high]]) {
                points.push(x, y, planeAt(x, y) - lowered);
                colours.push(...colourOf(friction).toArray());
            }
            add(points, [0, 1, 2, 1, 3, 2], colours, layer);
        }

        // Higher places are lighter, so that unevenness of centimetres can be seen.
        function addMesh(mesh) {
            const points = [], colours = [], triangles = [];
            const largest = Math.max(-mesh.lowest, mesh.lowest + 65535 * mesh.step);
            let next = 0;
            for (const [i, j, cells] of mesh.tiles) {
                const first = points.length / 3, row = cells + 1;
                for (let node = 0; node < row * row; ++node) {
                    const x = mesh.tile * (i + Math.floor(node / row) / cells), y = mesh.tile * (j + node % row / cells);
                    const above = mesh.lowest + mesh.step * decoded[next++];
                    const light = 1 + 0.4 * above / largest;
                    points.push(x, y, planeAt(x, y) + above);
                    colours.push(...colourOf(frictionAt(x, y)).multiplyScalar(light).toArray());
                }
                for (let u = 0; u < cells; ++u) {
                    for (let v = 0; v < cells; ++v) {
                        const a = first + u * row + v, b = a + row;
                        triangles.push(a, b, a + 1, b, b + 1, a + 1);
                    }
                }
            }
            add(points, triangles, colours, 0);
        }

        addRectangle(road.area, road.friction, 0);
        road.patches.forEach((patch, i) => addRectangle(patch.area, patch.friction, i + 1));
        if (road.mesh) addMesh(road.mesh);
        return group;
    }

    // What the colours mean: nothing to say of an ordinary road.
    function legend(road) {
        const frictions = new Set([road.friction, ...road.patches.map(patch => patch.friction)]);
        if (frictions.size === 1 && frictions.has(1)) return [];
        return Array.from(frictions).map(friction =>
            ({text: 'friction ' + values.format(friction), colour: colourOf(friction).getStyle()}));
    }

    return {build, cones, legend};
})();
