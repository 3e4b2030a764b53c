// Time charts of a report: draws each from the values in #chart-data; all share one cursor and one zoom in time.
(function () {
    'use strict';

    const {decode, escaped, format, element, read} = values;

    function rowsOf(data, packed) {
        const time = decode(data.time, Float64Array);
        const curves = packed.map(values => decode(values, Float32Array));
        return Array.from(time, (t, i) => [t].concat(curves.map(values => values[i])));
    }

    const light = colour => colour + '30';  // nearly transparent

    // Names always, values while the cursor is on a chart.
    function legend(figure, data) {
        return function (state) {
            const out = document.createDocumentFragment();
            data.curves.forEach((curve, i) => {
                const item = element('span');
                const line = element('i', curve.dashed ? 'dashed' : '');
                line.style.borderColor = curve.colour;
                line.style.borderTopWidth = Math.max(2.5, curve.width) + 'px';
                const selected = state.x !== undefined && state.series[i] && state.series[i].y !== undefined;
                item.append(line, curve.name, element('b', '', selected ? format(state.series[i].y) : ''));
                out.append(item);
            });
            if (data.envelope) {
                const item = element('span'), patch = element('i', 'patch');
                patch.style.background = light(data.envelope.colour);
                item.append(patch, data.envelope.name);
                out.append(item);
            }
            figure.querySelector('.now').textContent =
                state.x === undefined ? '' : 't = ' + Number(state.x.toFixed(4)) + ' s';
            return out;
        };
    }

    // The last two values of each row are the lower and the upper edge; where one of them is missing, there is a gap.
    function drawEnvelope(canvas, area, chart, colour, rows) {
        const edges = rows.map(row => [row[0], ...row.slice(-2)]);
        canvas.save();
        canvas.beginPath();
        canvas.rect(area.x, area.y, area.w, area.h);
        canvas.clip();
        canvas.beginPath();
        for (let from = 0, to; from < edges.length; from = to + 1) {
            for (to = from; to < edges.length && edges[to].every(Number.isFinite);) ++to;
            const part = edges.slice(from, to), back = part.slice().reverse();
            const corners = part.map(([t, low]) => [t, low]).concat(back.map(([t, , high]) => [t, high]));
            corners.forEach(([t, y], i) => canvas[i ? 'lineTo' : 'moveTo'](chart.toDomXCoord(t), chart.toDomYCoord(y)));
        }
        canvas.fillStyle = light(colour);
        canvas.fill();
        canvas.restore();
    }

    function underlay(data, rows) {
        return function (canvas, area, chart) {
            if (data.envelope) drawEnvelope(canvas, area, chart, data.envelope.colour, rows);
            if (data.band) {
                const top = chart.toDomYCoord(data.band), bottom = chart.toDomYCoord(-data.band);
                canvas.fillStyle = 'rgba(26, 154, 107, 0.16)';
                canvas.fillRect(area.x, top, area.w, bottom - top);
            }
            canvas.fillStyle = '#a35bc4';
            for (const time of data.marks) {
                const x = chart.toDomXCoord(time);
                for (let y = area.y; y < area.y + area.h; y += 8) canvas.fillRect(x - 0.75, y, 1.5, 5);
            }
        };
    }

    // Charts hold different samples (each keeps its own peaks): a moment selects the nearest one.
    function nearestRow(x) {
        let low = 0, high = this.numRows() - 1;
        while (high - low > 1) {
            const middle = (low + high) >> 1;
            if (this.getValue(middle, 0) < x) low = middle; else high = middle;
        }
        return x - this.getValue(low, 0) < this.getValue(high, 0) - x ? low : high;
    }

    // The range in y of the rows between two moments: all values, the band, and never a range so small that rounding errors
    // fill the chart.
    function rangeOf(rows, band, from, to) {
        let low = band ? -band : Infinity, high = band ? band : -Infinity;
        for (const row of rows) {
            if (row[0] < from || row[0] > to) continue;
            for (let i = 1; i < row.length; ++i) {
                if (row[i] < low) low = row[i];
                if (row[i] > high) high = row[i];
            }
        }
        if (low > high) return [0, 1];
        const size = Math.max(Math.abs(low), Math.abs(high));
        if (size < 1e-12) return [-1, 1];
        if (high - low < 1e-5 * size) return [low - 0.1 * size, high + 0.1 * size];
        const padding = 0.06 * (high - low);
        return [low - padding, high + padding];
    }

    // Ticks at the largest step of 1, 2 or 5 times a power of ten that gives at least three: they are then at most eight.
    function valueTicks(low, high) {
        const least = 3;
        let step = Math.pow(10, Math.ceil(Math.log10(high - low)));
        const count = () => Math.floor(high / step + 1e-9) - Math.ceil(low / step - 1e-9) + 1;
        for (let i = 0; count() < least && i < 9; ++i) step /= i % 3 === 1 ? 2.5 : 2;
        const ticks = [];
        for (let i = Math.ceil(low / step - 1e-9); i <= Math.floor(high / step + 1e-9); ++i)
            ticks.push({v: i * step, label: format(i * step)});
        return ticks;
    }

    // A dot on each curve and one line through all charts at the selected moment.
    function drawSelected(chart, name, canvas, x, y, colour, radius) {
        if (name === '0') {
            const area = chart.getArea();
            canvas.fillStyle = 'rgba(128, 136, 146, 0.7)';
            canvas.fillRect(x - 0.5, area.y, 1, area.h);
        }
        canvas.beginPath();
        canvas.fillStyle = colour;
        canvas.arc(x, y, radius, 0, 2 * Math.PI);
        canvas.fill();
    }

    // With a finger, dragging scrolls the page and a tap selects; with a mouse, dragging zooms.
    function interactions() {
        const model = Object.assign({}, Dygraph.defaultInteractionModel);
        for (const name of ['touchstart', 'touchmove', 'touchend']) delete model[name];
        model.dblclick = resetZoom;
        return model;
    }

    const button = document.getElementById('reset');
    const charts = [];
    const everything = [-Infinity, Infinity];
    let shownTime = everything;

    // After a zoom in time every chart fits its values to what is left; a zoom in y stays with its chart.
    function fitValues(from, to) {
        button.hidden = false;
        const time = this.isZoomed('x') ? [from, to] : everything;
        if (time[0] === shownTime[0] && time[1] === shownTime[1]) return;
        shownTime = time;
        for (const {chart, rows, band} of charts) chart.updateOptions({valueRange: rangeOf(rows, band, ...time)});
    }

    // Only the first chart is told to draw: the synchronizer passes its time on, and each other chart draws once.
    function resetZoom() {
        shownTime = everything;
        for (const {chart, rows, band} of charts) chart.updateOptions({valueRange: rangeOf(rows, band, ...everything)}, true);
        charts[0].chart.updateOptions({dateWindow: null});
        button.hidden = true;
    }

    function draw(data, figure) {
        const drawn = data.curves.map(curve => curve.values), envelope = data.envelope;
        const rows = rowsOf(data, envelope ? drawn.concat(envelope.low, envelope.high) : drawn);
        const chart = new Dygraph(figure.querySelector('.canvas'), envelope ? rowsOf(data, drawn) : rows, {
            labels: ['time'].concat(data.curves.map((curve, i) => String(i))),  // shown names may repeat, these may not
            series: Object.fromEntries(data.curves.map((curve, i) => [String(i), {
                color: curve.colour,
                strokeWidth: curve.width,
                strokePattern: curve.dashed ? [7, 3] : null
            }])),
            valueRange: rangeOf(rows, data.band, ...shownTime),
            xlabel: 'time [s]',
            ylabel: escaped(data.unit || '–'),  // the library takes labels for markup
            xLabelHeight: 16,
            yLabelWidth: 16,
            labelsDiv: figure.querySelector('.legend'),
            legend: 'always',
            legendFormatter: legend(figure, data),
            underlayCallback: underlay(data, rows),
            drawHighlightPointCallback: drawSelected,
            interactionModel: interactions(),
            axes: {
                x: {axisLabelFormatter: format, pixelsPerLabel: 46},
                y: {ticker: valueTicks, axisLabelWidth: 54}
            },
            gridLineColor: 'rgba(128, 136, 146, 0.22)',
            gridLineWidth: 1,
            axisLineColor: 'rgba(128, 136, 146, 0.8)',
            highlightCircleSize: 3.5,
            zoomCallback: fitValues
        });
        chart.getRowForX = nearestRow;
        figure.querySelector('.canvas').addEventListener('mousemove', () => {
            const row = chart.getSelection();
            if (row >= 0) document.dispatchEvent(new CustomEvent('tread-moment', {detail: chart.getValue(row, 0)}));
        });
        return {chart, rows, band: data.band};
    }

    // Chart by chart, so that the text of the page can be read while the charts appear.
    const all = read('chart-data');
    function drawNext() {
        const stop = performance.now() + 15;
        while (charts.length < all.length && performance.now() < stop) {
            charts.push(draw(all[charts.length], document.getElementById('c' + charts.length)));
        }
        if (charts.length < all.length) {
            setTimeout(drawNext);
            return;
        }
        if (charts.length > 1) {
            Dygraph.synchronize(charts.map(each => each.chart), {selection: true, zoom: true, range: false});
        }
        document.body.classList.remove('drawing');
    }
    document.body.classList.add('drawing');  // no pointing at charts that do not yet know each other
    setTimeout(drawNext);
    button.addEventListener('click', resetZoom);

    // A chart that is folded away has no width until its section is opened.
    document.addEventListener('toggle', event => {
        for (const figure of event.target.querySelectorAll('.time-chart')) {
            const drawn = charts[Number(figure.id.slice(1))];
            if (drawn) drawn.chart.resize();
        }
    }, true);

    // Paper has another width than the window.
    const resizeAll = () => charts.forEach(each => each.chart.resize());
    window.addEventListener('beforeprint', resizeAll);
    window.addEventListener('afterprint', resizeAll);
})();
