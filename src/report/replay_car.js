// A car of a replay: a box with four wheels that steer, spin and travel; the forces of its tyres as arrows.
const replayCar = (function () {
    'use strict';

    const kTyreWidth = 0.2, kHead = 0.16;  // m
    const kLoadColours = ['#3b4cc0', '#2a9fb4', '#7fbf5a', '#f2c230', '#d7301f'];  // from no load to the largest

    function mesh(geometry, colour, more) {
        const made = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial(Object.assign({color: colour}, more)));
        made.castShadow = true;
        return made;
    }

    function loadColour(share, out) {
        const at = Math.min(1, Math.max(0, share)) * (kLoadColours.length - 1);
        const step = Math.min(kLoadColours.length - 2, Math.floor(at));
        return out.set(kLoadColours[step]).lerp(new THREE.Color(kLoadColours[step + 1]), at - step);
    }

    // Seen from its right side, then drawn out over the width. Origin: the centre of gravity.
    function extruded(outline, width) {
        const shape = new THREE.Shape(outline.map(([x, z]) => new THREE.Vector2(x, z)));
        const geometry = new THREE.ExtrudeBufferGeometry(shape, {depth: width, bevelEnabled: false});
        return geometry.rotateX(Math.PI / 2).translate(0, width / 2, 0);
    }

    function body(data) {
        const group = new THREE.Group();
        const ground = -data.height, front = data.ahead, rear = -data.behind, length = front - rear;
        const bottom = ground + 0.2, belt = ground + 0.62 * data.roof, roof = ground + data.roof;
        const width = data.width - kTyreWidth - 0.1;  // between the wheels, so that they can be seen
        const hull = mesh(extruded([[rear, bottom], [front, bottom], [front, belt - 0.22], [front - 0.28 * length, belt],
                                    [rear, belt]], width), data.colour);
        const cabin = mesh(extruded([[rear + 0.04 * length, belt], [front - 0.27 * length, belt],
                                     [front - 0.43 * length, roof], [rear + 0.12 * length, roof]], width - 0.16), '#20262d');
        const top = mesh(extruded([[rear + 0.12 * length, roof], [front - 0.43 * length, roof],
                                   [front - 0.43 * length, roof + 0.03], [rear + 0.12 * length, roof + 0.03]], width - 0.16),
                         data.colour);
        group.add(hull, cabin, top);
        return group;
    }

    function arrow() {
        const group = new THREE.Group();
        const material = new THREE.MeshBasicMaterial({color: '#ff2bd6', depthTest: false, transparent: true});
        const shaft = new THREE.Mesh(new THREE.BoxBufferGeometry(1, 0.05, 0.02).translate(0.5, 0, 0), material);
        const head = new THREE.Mesh(new THREE.ConeBufferGeometry(0.08, kHead, 12).rotateZ(-Math.PI / 2), material);
        shaft.renderOrder = head.renderOrder = 10;  // seen through the body
        group.add(shaft, head);
        group.set = function (along, across) {
            const length = Math.hypot(along, across);
            const size = Math.min(1, length / (1.5 * kHead));  // a small force has a small arrow
            group.visible = length > 0.01;
            group.rotation.z = Math.atan2(across, along);
            shaft.scale.x = Math.max(0.001, length - size * kHead);
            head.scale.setScalar(Math.max(0.001, size));
            head.position.x = length - size * kHead / 2;
        };
        return group;
    }

    function wheel(data) {
        const hub = new THREE.Group(), turning = new THREE.Group(), force = arrow();
        const tyre = mesh(new THREE.CylinderBufferGeometry(data.radius, data.radius, kTyreWidth, 32), '#888888');
        turning.add(tyre);
        for (const angle of [0, Math.PI / 3, 2 * Math.PI / 3]) {
            const spokes = mesh(new THREE.BoxBufferGeometry(1.3 * data.radius, kTyreWidth + 0.02, 0.06), '#1d2126');
            spokes.rotation.y = angle;
            turning.add(spokes);
        }
        hub.add(turning, force);
        hub.rotation.order = 'ZXY';
        force.position.z = 0.01 - data.radius;
        return {hub, turning, tyre, force, data, channels: decoded(data.channels)};
    }

    function decoded(channels) {
        return Object.fromEntries(Object.entries(channels).map(([name, text]) => [name, values.decode(text, Float32Array)]));
    }

    // `units`: {load: N of the last colour, force: N per metre of arrow}.
    function build(data, units) {
        const time = values.decode(data.time, Float64Array), channels = decoded(data.channels);
        const wheels = data.wheels.map(wheel);
        const car = new THREE.Group();
        car.rotation.order = 'ZYX';
        car.add(body(data), ...wheels.map(each => each.hub));

        // Between which frames a moment lies.
        function place(moment) {
            let low = 0, high = time.length - 1;
            while (high - low > 1) {
                const middle = (low + high) >> 1;
                if (time[middle] <= moment) low = middle; else high = middle;
            }
            return {low, share: Math.min(1, Math.max(0, (moment - time[low]) / (time[low + 1] - time[low])))};
        }
        function read(channel, {low, share}) {
            return channel ? channel[low] + share * (channel[low + 1] - channel[low]) : 0;
        }
        // Between two headings the short way round.
        function readAngle(channel, {low, share}) {
            if (!channel) return 0;
            const change = channel[low + 1] - channel[low];
            return channel[low] + share * (change - 2 * Math.PI * Math.round(change / (2 * Math.PI)));
        }

        function show(moment) {
            const at = place(moment);
            car.position.set(read(channels.x, at), read(channels.y, at), read(channels.z, at));
            car.rotation.set(readAngle(channels.roll, at), readAngle(channels.pitch, at), readAngle(channels.yaw, at));
            for (const {hub, turning, tyre, force, data, channels} of wheels) {
                const [x, y, z] = data.hub;
                hub.position.set(x, y, z + read(channels.travel, at));
                hub.rotation.set(read(channels.lean, at), 0, read(channels.steer, at));
                turning.rotation.y = read(channels.turn, at);
                if (channels.load) loadColour(read(channels.load, at) / units.load, tyre.material.color);
                force.set(read(channels.fx, at) / units.force, read(channels.fy, at) / units.force);
            }
        }

        // The way of the centre of gravity, on the road.
        function trace() {
            const points = [];
            for (let i = 0; i < time.length; ++i)
                points.push(new THREE.Vector3(channels.x[i], channels.y[i], channels.z[i] - data.height + 0.03));
            const geometry = new THREE.BufferGeometry().setFromPoints(points);
            return new THREE.Line(geometry, new THREE.LineBasicMaterial({color: data.colour}));
        }

        return {
            data, object: car, trace, show, time,
            showForces: on => wheels.forEach(each => { each.force.children.forEach(part => { part.visible = on; }); }),
            heading: moment => readAngle(channels.yaw, place(moment)),
            has: name => name in channels,
            value: (name, moment) => read(channels[name], place(moment))
        };
    }

    // The largest value of a channel over the wheels of all cars.
    function largest(cars, name) {
        let most = 0;
        for (const car of cars) {
            for (const {channels} of car.wheels) {
                if (channels[name]) for (const value of values.decode(channels[name], Float32Array)) most = Math.max(most, Math.abs(value));
            }
        }
        return most;
    }

    return {build, largest, loadColours: kLoadColours};
})();
