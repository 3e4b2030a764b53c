// The demo's shaders: sun with shadow, sky, haze, and the ground's grid of 1 m and 10 m.
#pragma once

namespace tread::demo {

inline constexpr const char* kDepthVertex = R"(#version 330 core
layout(location = 0) in vec3 at;
uniform mat4 model, light;
void main() { gl_Position = light * model * vec4(at, 1.0); }
)";
inline constexpr const char* kDepthFragment = "#version 330 core\nvoid main() {}\n";

inline constexpr const char* kSceneVertex = R"(#version 330 core
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in float gloss;
uniform mat4 model, view, light;
out vec3 place, across, tint;
out vec4 in_light;
flat out float shine;
void main() {
    vec4 world = model * vec4(at, 1.0);
    place = world.xyz;
    across = mat3(model) * normal;
    tint = colour;
    shine = gloss;
    in_light = light * world;
    gl_Position = view * world;
})";

inline constexpr const char* kSceneFragment = R"(#version 330 core
in vec3 place, across, tint;
in vec4 in_light;
flat in float shine;
uniform vec3 eye, sun;
uniform sampler2DShadow shadow;
out vec4 result;

const vec3 kSunlight = vec3(0.92, 0.87, 0.78), kHorizon = vec3(0.62, 0.71, 0.80), kZenith = vec3(0.20, 0.38, 0.66);

float lit() {
    vec3 p = 0.5 * in_light.xyz + 0.5;
    if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 1.0;
    float sum = 0.0;
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            sum += texture(shadow, vec3(p.xy + vec2(i, j) * 0.8 / 2048.0, p.z - 0.0012));
    return sum / 9.0;
}

// Lines each so many metres, as thin as the picture allows, gone where they would flicker.
float lines(float each, float width) {
    vec2 at = place.xz / each;
    vec2 step = fwidth(at);
    vec2 away = abs(fract(at - 0.5) - 0.5);
    vec2 line = 1.0 - smoothstep(vec2(0.5 * width / each), vec2(0.5 * width / each) + 1.5 * step, away);
    return max(line.x * clamp(1.0 - 3.0 * step.x, 0.0, 1.0), line.y * clamp(1.0 - 3.0 * step.y, 0.0, 1.0));
}

void main() {
    vec3 to_eye = normalize(eye - place);
    vec3 n = normalize(across);
    if (dot(n, to_eye) < 0.0) n = -n;
    vec3 colour = tint;
    if (shine == 2.0) colour = mix(mix(colour, vec3(0.50), 0.30 * lines(1.0, 0.015)), vec3(0.80), 0.6 * lines(10.0, 0.05));
    vec3 light = mix(vec3(0.26, 0.25, 0.24), vec3(0.42, 0.48, 0.58), 0.5 + 0.5 * n.y);
    light += kSunlight * max(dot(n, sun), 0.0) * lit();
    vec3 shown = shine == 3.0 ? colour : colour * light;
    if (shine > 0.0 && shine < 2.0) {
        vec3 back = reflect(-to_eye, n);
        float edge = pow(1.0 - max(dot(n, to_eye), 0.0), 4.0);
        shown = mix(shown, mix(kHorizon, kZenith, clamp(1.5 * back.y, 0.0, 1.0)), shine * (0.10 + 0.6 * edge));
        shown += 0.7 * shine * kSunlight * pow(max(dot(back, sun), 0.0), 60.0) * lit();
    }
    float haze = shine == 3.0 ? 0.0 : 1.0 - exp(-pow(length(eye - place) / 260.0, 2.0));
    result = vec4(mix(shown, kHorizon, haze), 1.0);
})";

inline constexpr const char* kSkyVertex = R"(#version 330 core
uniform mat4 back;
out vec3 ray;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    vec4 far = back * vec4(corner, 1.0, 1.0);
    vec4 near = back * vec4(corner, -1.0, 1.0);
    ray = far.xyz / far.w - near.xyz / near.w;
    gl_Position = vec4(corner, 0.999999, 1.0);
})";
inline constexpr const char* kSkyFragment = R"(#version 330 core
in vec3 ray;
out vec4 result;
void main() {
    float up = clamp(1.6 * normalize(ray).y, 0.0, 1.0);
    result = vec4(mix(vec3(0.62, 0.71, 0.80), vec3(0.20, 0.38, 0.66), pow(up, 0.7)), 1.0);
})";

}  // namespace tread::demo
