// The replay: draws the cars of #replay-data on their road, with a time line, a speed and three cameras.
(function () {
    'use strict';

    const {element, format, read} = values;
    const kLag = 0.4;  // s by which the follow camera turns later than the car
    const kAside = 0.4;  // rad by which it looks from the right rear, so that forces along the car can be seen
    const data = read('replay-data');
    const holder = document.getElementById('replay');

    // ---- Scene ----

    function renderer() {
        try {
            const made = new THREE.WebGLRenderer({antialias: true});
            made.shadowMap.enabled = true;
            made.setPixelRatio(Math.min(2, window.devicePixelRatio));
            return made;
        } catch (error) {
            return null;
        }
    }

    // A round number that is not less.
    function round(value) {
        const power = Math.pow(10, Math.floor(Math.log10(value)));
        return power * [1, 2, 5, 10].find(step => step * power >= value * (1 - 1e-9));
    }

    const painter = renderer();
    if (!painter) {
        holder.append(element('p', 'hint', 'The replay needs WebGL, which this browser does not offer.'));
        return;
    }
    const dark = window.matchMedia('(prefers-color-scheme: dark)').matches;
    const sky = new THREE.Color(dark ? '#232a32' : '#d5e2ee');
    const scene = new THREE.Scene();
    scene.background = sky;
    scene.fog = new THREE.Fog(sky, 40, 220);
    const units = {
        load: Math.ceil((replayCar.largest(data.cars, 'load') || 1) / 1000) * 1000,
        force: round((Math.max(replayCar.largest(data.cars, 'fx'), replayCar.largest(data.cars, 'fy')) || 1) / 2)
    };
    const cars = data.cars.map(each => replayCar.build(each, units));
    const sun = new THREE.DirectionalLight('#ffffff', 0.6);
    sun.castShadow = true;
    Object.assign(sun.shadow.camera, {left: -6, right: 6, top: 6, bottom: -6, near: 1, far: 60});
    sun.shadow.mapSize.set(1024, 1024);
    scene.add(new THREE.HemisphereLight('#ffffff', '#b4b9c0', 0.75), sun, sun.target,
              replayRoad.build(data.road, painter.capabilities.getMaxAnisotropy()), replayRoad.cones(data.cones));
    for (const car of cars) scene.add(car.object, car.trace());

    // ---- Controls ----

    const from = Math.min(...cars.map(car => car.time[0]));
    const to = Math.max(...cars.map(car => car.time[car.time.length - 1]));
    const state = {time: from, playing: false, speed: 1, view: 'Follow', followed: cars[0]};

    function labelled(text, control) {
        const label = element('label', '', text + ' ');
        label.append(control);
        return label;
    }
    function choice(label, options, chosen, change) {
        const select = element('select');
        options.forEach((text, i) => select.append(new Option(text, i)));
        select.value = chosen;
        select.addEventListener('change', () => change(Number(select.value)));
        return labelled(label, select);
    }

    const play = element('button', 'play', '▶ Play');
    play.type = 'button';
    const line = Object.assign(element('input'), {type: 'range', min: from, max: to, step: 'any', value: from});
    line.setAttribute('aria-label', 'time');
    const forces = Object.assign(element('input'), {type: 'checkbox', checked: true});
    const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 5], kViews = ['Follow', 'Orbit', 'Top'];
    const stage = element('div', 'stage'), numbers = element('div', 'numbers'), legend = element('div', 'key');
    const bar = element('div', 'bar');
    stage.append(painter.domElement, numbers, legend);
    painter.domElement.tabIndex = 0;
    painter.domElement.setAttribute('role', 'img');
    painter.domElement.setAttribute('aria-label', 'Replay of ' + data.cars.map(car => car.name).join(', '));
    bar.append(play, line, choice('Speed', kSpeeds.map(speed => speed + ' ×'), 3, i => { state.speed = kSpeeds[i]; }),
               choice('View', kViews, 0, i => { look(kViews[i]); }));
    if (cars.length > 1) bar.append(choice('Car', cars.map(car => car.data.name), 0, i => { follow(cars[i]); }));
    bar.append(labelled('Tyre forces', forces));
    holder.append(stage, bar);

    function key(text, background) {
        const item = element('span'), mark = element('i');
        mark.style.background = background;
        item.append(mark, text);
        return item;
    }
    if (replayCar.largest(data.cars, 'load') > 0) {
        legend.append(key('wheel load 0 to ' + format(units.load / 1000) + ' kN',
                          'linear-gradient(to right, ' + replayCar.loadColours.join(', ') + ')'));
    }
    if (replayCar.largest(data.cars, 'fx') + replayCar.largest(data.cars, 'fy') > 0)
        legend.append(key('tyre force, 1 m = ' + format(units.force / 1000) + ' kN', '#ff2bd6'));
    for (const {text, colour} of replayRoad.legend(data.road)) legend.append(key(text, colour));

    // ---- Cameras ----

    const camera = new THREE.PerspectiveCamera(38, 2, 0.1, 600);
    camera.up.set(0, 0, 1);
    const orbit = new THREE.OrbitControls(camera, painter.domElement);
    orbit.maxPolarAngle = 0.495 * Math.PI;
    orbit.enabled = false;
    orbit.addEventListener('change', () => { if (state.view === 'Orbit') paint(); });
    const distance = {Follow: 9.5, Top: 34};

    function look(view) {
        const before = state.view;
        state.view = view;
        orbit.enabled = view === 'Orbit';
        camera.up.set(0, view === 'Top' ? 1 : 0, view === 'Top' ? 0 : 1);
        if (view === 'Orbit' && before !== view) {
            const at = state.followed.object.position;
            camera.position.set(at.x - 5, at.y - 7, at.z + 3);
            orbit.target.copy(at);
        }
        draw();
    }
    function follow(car) {
        state.followed = car;
        draw();
    }

    function aim() {
        const at = state.followed.object.position;
        if (state.view === 'Orbit') {
            camera.position.add(at).sub(orbit.target);
            orbit.target.copy(at);
            orbit.update();
        } else if (state.view === 'Top') {
            camera.position.set(at.x, at.y, at.z + distance.Top);
            camera.lookAt(at);
        } else {
            const from = state.followed.heading(state.time - kLag) + kAside, d = distance.Follow;
            camera.position.set(at.x - d * Math.cos(from), at.y - d * Math.sin(from), at.z + 0.36 * d);
            camera.lookAt(at.x, at.y, at.z + 0.2);
        }
        sun.target.position.copy(at);
        sun.position.set(at.x - 8, at.y + 12, at.z + 18);
    }

    // The wheel of the mouse belongs to the page until the picture has been clicked.
    painter.domElement.addEventListener('wheel', event => {
        if (state.view === 'Orbit' || document.activeElement !== painter.domElement) return;
        event.preventDefault();
        distance[state.view] = Math.min(200, Math.max(3, distance[state.view] * (event.deltaY > 0 ? 1.12 : 1 / 1.12)));
        draw();
    }, {passive: false});
    painter.domElement.addEventListener('focus', () => { orbit.enableZoom = true; });
    painter.domElement.addEventListener('blur', () => { orbit.enableZoom = false; });
    orbit.enableZoom = false;
    painter.domElement.addEventListener('pointerdown', () => painter.domElement.focus({preventScroll: true}));

    // ---- Drawing ----

    function paint() {
        painter.render(scene, camera);
    }

    function tell() {
        numbers.replaceChildren(element('b', '', 't = ' + state.time.toFixed(2) + ' s'));
        for (const car of cars) {
            const row = element('span'), parts = [];
            if (cars.length > 1) parts.push(car.data.name);
            if (car.has('vx')) parts.push((3.6 * car.value('vx', state.time)).toFixed(1) + ' km/h');
            for (const name of ['ax', 'ay']) {
                if (car.has(name)) parts.push(name + ' ' + (Number(car.value(name, state.time).toFixed(1)) + 0).toFixed(1) + ' m/s²');
            }
            row.textContent = parts.join(' · ');
            if (cars.length > 1) row.style.borderLeft = '4px solid ' + car.data.colour;
            numbers.append(row);
        }
    }

    function draw() {
        for (const car of cars) car.show(state.time);
        for (const car of cars) car.showForces(forces.checked);
        aim();
        paint();
        tell();
        line.value = state.time;
    }

    let last = null;
    function step(now) {
        if (!state.playing) return;
        if (last !== null) state.time = Math.min(to, state.time + state.speed * (now - last) / 1000);
        last = now;
        draw();
        if (state.time >= to) pause(); else requestAnimationFrame(step);
    }
    function pause() {
        state.playing = false;
        play.textContent = '▶ Play';
    }
    function toggle() {
        if (state.playing) {
            pause();
            return;
        }
        if (state.time >= to) state.time = from;
        state.playing = true;
        last = null;
        play.textContent = '❚❚ Pause';
        requestAnimationFrame(step);
    }
    function jump(time) {
        state.time = Math.min(to, Math.max(from, time));
        draw();
    }

    play.addEventListener('click', toggle);
    line.addEventListener('input', () => jump(Number(line.value)));
    forces.addEventListener('change', draw);
    painter.domElement.addEventListener('keydown', event => {
        if (event.key !== ' ') return;
        event.preventDefault();
        toggle();
    });
    // Pointing at a chart shows that moment here, unless the replay runs.
    document.addEventListener('tread-moment', event => { if (!state.playing) jump(event.detail); });

    new ResizeObserver(() => {
        const width = stage.clientWidth, height = stage.clientHeight;
        if (!width || !height) return;
        painter.setSize(width, height, false);
        camera.aspect = width / height;
        camera.updateProjectionMatrix();
        draw();
    }).observe(stage);
})();
