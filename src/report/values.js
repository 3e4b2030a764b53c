// What all scripts of a page need: values out of base64, numbers for people, elements.
const values = (function () {
    'use strict';

    function decode(base64, Type) {
        const text = atob(base64);
        const bytes = new Uint8Array(text.length);
        for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
        return new Type(bytes.buffer);
    }

    // Five digits, without an exponent where people would not write one.
    function format(value) {
        if (!Number.isFinite(value)) return '–';
        const size = Math.abs(value);
        if (size >= 1e5 && size < 1e9) return value.toFixed(0);
        if (size > 0 && size < 1e-4) return Number(value.toPrecision(3)).toExponential();
        return String(Number(value.toPrecision(5)));
    }

    function element(name, className, text) {
        const made = document.createElement(name);
        if (className) made.className = className;
        if (text !== undefined) made.textContent = text;
        return made;
    }

    // Text for where a library takes markup.
    function escaped(text) {
        const names = {'&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;'};
        return String(text).replace(/[&<>"']/g, sign => names[sign]);
    }

    // The values of a script element, or null without one.
    function read(id) {
        const holder = document.getElementById(id);
        return holder && JSON.parse(holder.textContent);
    }

    return {decode, escaped, format, element, read};
})();
