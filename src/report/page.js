// Time charts of a report: draws each from the values in #chart-data; all share one cursor and one zoom in time.
(function () {
    'use strict';

    function decode(base64, Type) {
        const text = atob(base64);
        const bytes = new Uint8Array(text.length);
        for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
        return new Type(bytes.buffer);
    }

    function rowsOf(data) {
        const time = decode(data.time, Float64Array);
        const curves = data.curves.map(curve => decode(curve.values, Float32Array));
        return Array.from(time, (t, i) => [t].concat(curves.map(values => values[i])));
    }

    // Five digits, without an exponent where people would not write one.
    function format(value) {
        if (!Number.isFinite(value)) return '–';
        const size = Math.abs(value);
        if (size >= 1e5 && size < 1e9) return value.toFixed(0);
        if (size > 0 && size < 1e-4) return value.toExponential(2);
        return String(Number(value.toPrecision(5)));
    }

    function element(name, className, text) {
        const made = document.createElement(name);
        if (className) made.className = className;
        if (text !== undefined) made.textContent = text;
        return made;
    }

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
            figure.querySelector('.now').textContent =
                state.x === undefined ? '' : 't = ' + Number(state.x.toFixed(4)) + ' s';
            return out;
        };
    }

    function underlay(data) {
        return function (canvas, area, chart) {
            if (data.band) {
                const top = chart.toDomYCoord(data.band), bottom = chart.toDomYCoord(-data.band);
                canvas.fillStyle = 'rgba(26, 154, 107, 0.16)';
                canvas.fillRect(area.x, top, area.w, bottom - top);
            }
            for (const mark of data.marks) {
                const x = chart.toDomXCoord(mark.time);
                if (x < area.x || x > area.x + area.w) continue;
                canvas.fillStyle = '#d9480f';
                canvas.fillRect(x - 0.75, area.y, 1.5, area.h);
                canvas.font = '12px system-ui, sans-serif';
                const left = x < area.x + area.w / 2;
                canvas.textAlign = left ? 'left' : 'right';
                canvas.fillText(mark.text, x + (left ? 5 : -5), area.y + 12);
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

    // The range in y: all values, the band, and never a range so small that rounding errors fill the chart.
    function rangeOf(rows, band) {
        let low = band ? -band : Infinity, high = band ? band : -Infinity;
        for (const row of rows) {
            for (let i = 1; i < row.length; ++i) {
                if (row[i] < low) low = row[i];
                if (row[i] > high) high = row[i];
            }
        }
        if (low > high) return [0, 1];
        const size = Math.max(1e-3, Math.abs(low), Math.abs(high));
        if (high - low < 1e-5 * size) return [low - 0.1 * size, high + 0.1 * size];
        const padding = 0.06 * (high - low);
        return [low - padding, high + padding];
    }

    // With a finger, dragging scrolls the page and a tap selects; with a mouse, dragging zooms.
    function interactions() {
        const model = Object.assign({}, Dygraph.defaultInteractionModel);
        for (const name of ['touchstart', 'touchmove', 'touchend']) delete model[name];
        model.dblclick = resetZoom;
        return model;
    }

    function draw(data, figure) {
        const rows = rowsOf(data);
        const chart = new Dygraph(figure.querySelector('.canvas'), rows, {
            labels: ['time'].concat(data.curves.map((curve, i) => String(i))),  // shown names may repeat, these may not
            series: Object.fromEntries(data.curves.map((curve, i) => [String(i), {
                color: curve.colour,
                strokeWidth: curve.width,
                strokePattern: curve.dashed ? [7, 3] : null
            }])),
            valueRange: rangeOf(rows, data.band),
            xlabel: 'time [s]',
            ylabel: data.unit || '–',
            xLabelHeight: 16,
            yLabelWidth: 16,
            labelsDiv: figure.querySelector('.legend'),
            legend: 'always',
            legendFormatter: legend(figure, data),
            underlayCallback: underlay(data),
            interactionModel: interactions(),
            axes: {
                x: {axisLabelFormatter: format, pixelsPerLabel: 60},
                y: {axisLabelFormatter: format, axisLabelWidth: 54, pixelsPerLabel: 34}
            },
            gridLineColor: 'rgba(128, 136, 146, 0.28)',
            axisLineColor: 'rgba(128, 136, 146, 0.8)',
            highlightCircleSize: 3.5,
            animatedZooms: false,
            zoomCallback: showReset
        });
        chart.getRowForX = nearestRow;
        chart.wholeRange = rangeOf(rows, data.band);
        return chart;
    }

    const button = document.getElementById('reset');
    const charts = [];

    function showReset() {
        button.hidden = false;
    }

    function resetZoom() {
        for (const chart of charts) chart.updateOptions({dateWindow: null, valueRange: chart.wholeRange});
        button.hidden = true;
    }

    JSON.parse(document.getElementById('chart-data').textContent).forEach((data, i) => {
        charts.push(draw(data, document.getElementById('c' + i)));
    });
    if (charts.length > 1) Dygraph.synchronize(charts, {selection: true, zoom: true, range: false});
    button.addEventListener('click', resetZoom);

    // Paper has another width than the window.
    const resizeAll = () => charts.forEach(chart => chart.resize());
    window.addEventListener('beforeprint', resizeAll);
    window.addEventListener('afterprint', resizeAll);
})();
