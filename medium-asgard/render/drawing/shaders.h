// The shader programs: solids (instanced meshes, lit), the ground's shadows, lines (segments
// widened on screen), discs and the backdrop.
//
// Everything is in view coordinates (framing/camera.h), transformed in double precision before it
// gets here, so that a scene far from the origin does not tremble. Light is added up linearly and
// encoded as sRGB by the fragment shader; blending and resolving then happen in the encoded space,
// where equal steps look equal.
#pragma once

namespace render {

inline constexpr int mostLights = 8;

// How much of the shadowed light reaches a point: 0 to 1, the mean over a small disc of a map, the
// finest that shows the point. Goes before the source of a fragment shader that asks.
inline constexpr const char* shadowFunctions = R"(#version 330 core
uniform sampler2DShadow shadowMap;     // the maps side by side
uniform mat4 toMap[2];                  // view to the light's clip space
uniform vec2 texel;                     // of each map, view length
uniform vec2 softness;                  // of each map: radius of the disc
uniform int maps;                       // the first is of what is near, the last of everything
uniform int samples;                    // in the disc, or one in its middle
const vec2 disc[8] = vec2[8](vec2(-0.72, 0.42), vec2(0.60, -0.55), vec2(0.45, 0.72),
                             vec2(-0.48, -0.68), vec2(0.10, 0.14), vec2(0.95, 0.15),
                             vec2(-0.98, -0.12), vec2(0.02, -0.98));
// Software drivers take indices of uniforms badly that are no constants.
bool isNear(vec3 place) {
    vec4 q = toMap[0] * vec4(place, 1);
    return maps == 1 || max(abs(q.x), abs(q.y)) < 0.94 * q.w;
}
float of(vec2 maps, bool near) { return near ? maps.x : maps.y; }
float sampled(vec3 m, bool near) {
    float edge = 1.0 / float(textureSize(shadowMap, 0).y);
    vec2 inMap = clamp(m.xy, edge, 1.0 - edge);
    return texture(shadowMap, vec3(0.5 * inMap.x + (near ? 0.0 : 0.5), inMap.y, m.z));
}
float litAt(vec3 place, bool near) {
    vec4 one = vec4(place, 1);
    vec4 q = near ? toMap[0] * one : toMap[1] * one;
    vec3 m = 0.5 * q.xyz / q.w + 0.5;
    m.z = min(m.z, 1.0);
    if (samples == 1)
        return sampled(m, near);
    float sum = 0.0;
    for (int i = 0; i < samples; ++i)
        sum += sampled(vec3(m.xy + of(softness, near) * disc[i], m.z), near);
    return sum / float(samples);
}
)";

inline constexpr const char* solidVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 row0;      // mesh to view, three rows
layout(location = 3) in vec4 row1;
layout(location = 4) in vec4 row2;
layout(location = 5) in vec4 color;     // linear; alpha 1 is opaque
layout(location = 6) in vec2 material;  // shininess; depth of the quarters, negative: about y
uniform mat4 projection;
out vec3 place;
out vec3 facing;
out vec3 local;
flat out vec4 tint;
flat out vec2 surface;
void main() {
    vec4 p = vec4(position, 1);
    place = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
    facing = vec3(dot(row0.xyz, normal), dot(row1.xyz, normal), dot(row2.xyz, normal));
    local = position;
    tint = color;
    surface = material;
    gl_Position = projection * vec4(place, 1);
}
)";

inline constexpr const char* solidFragmentShader = R"(
in vec3 place;
in vec3 facing;
in vec3 local;
flat in vec4 tint;
flat in vec2 surface;
uniform vec3 up;
uniform float eye;                      // distance of the eye from view z = 0
uniform int lights;
uniform int shadowed;                   // the light of the map; -1: none
uniform vec3 beside;                    // light from beside the eye, without gloss
uniform vec4 lightPlace[8];             // w 0: unit direction towards it; 1: where it stands
uniform vec3 lightColor[8];
out vec4 pixel;

vec3 encoded(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

void main() {
    vec3 n = normalize(facing);
    if (!gl_FrontFacing)
        n = -n;
    vec3 toEye = normalize(vec3(0, 0, eye) - place);
    // A little light from everywhere, more from above: no face is black, and no two faces alike.
    float sky = 0.5 + 0.5 * dot(n, up);
    vec3 diffuse = mix(vec3(0.17, 0.165, 0.16), vec3(0.40, 0.42, 0.45), sky);
    diffuse += beside * max(dot(n, vec3(0.449, 0.249, 0.858)), 0.0);
    vec3 gloss = vec3(0);
    float power = mix(6.0, 160.0, surface.x * surface.x);
    for (int i = 0; i < lights; ++i) {
        vec3 toLight = lightPlace[i].w > 0.5 ? normalize(lightPlace[i].xyz - place) : lightPlace[i].xyz;
        float cosine = dot(n, toLight);
        if (cosine > 0.0) {
            vec3 light = lightColor[i];
            // Off the surface by some texels, more where the light grazes it, so that the whole
            // disc lies outside: nothing shades itself.
            bool near = isNear(place);
            float reach =
                samples == 1 ? 0.0 : of(softness, near) * float(textureSize(shadowMap, 0).y);
            float off = 2.5 - cosine + reach * sqrt(max(1.0 - cosine * cosine, 0.0));
            if (i == shadowed)
                light *= litAt(place + of(texel, near) * (off * n + toLight), near);
            diffuse += cosine * light;
            float mirrored = max(dot(n, normalize(toLight + toEye)), 0.0);
            gloss += pow(mirrored, power) * min(4.0 * cosine, 1.0) * light;
        }
    }
    vec3 albedo = tint.rgb;
    if (surface.y != 0.0) {
        // Opposite quarters of what turns are a shade darker, with a soft seam.
        float seam = local.x * (surface.y > 0.0 ? local.y : local.z);
        float width = max(fwidth(seam), 1e-4 * dot(local, local));
        albedo *= 1.0 - abs(surface.y) * smoothstep(-width, width, seam);
    }
    vec3 c = albedo * diffuse + 0.45 * surface.x * gloss;
    // Too much light keeps its hue instead of turning white.
    c /= max(1.0, max(c.r, max(c.g, c.b)) * 0.5 + 0.5);
    pixel = vec4(encoded(c), tint.a);
}
)";

// The depths of solids, as the light of a shadow map sees them.
inline constexpr const char* depthFragmentShader = R"(#version 330 core
void main() {}
)";

// The ground, which is not seen itself: only the shadows on it.
inline constexpr const char* groundVertexShader = R"(#version 330 core
uniform mat4 projection;
uniform vec3 corner[4];                 // view
out vec3 place;
void main() {
    place = corner[gl_VertexID];
    gl_Position = projection * vec4(place, 1);
}
)";

inline constexpr const char* groundFragmentShader = R"(
in vec3 place;
uniform vec3 toLight;
uniform vec4 ink;
out vec4 pixel;
void main() {
    bool near = isNear(place);
    float dark = 1.0 - litAt(place + of(texel, near) * toLight, near);
    if (dark <= 0.0)
        discard;
    pixel = vec4(ink.rgb, dark * ink.a);
}
)";

inline constexpr const char* lineVertexShader = R"(#version 330 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colorFrom; // sRGB, not premultiplied
layout(location = 3) in vec4 colorTo;
layout(location = 4) in vec2 width;     // pixels, at either end
uniform mat4 projection;
uniform vec2 halfSize;                  // of the picture, pixels
uniform float nearer;                   // moved towards the eye, in depth
out vec4 tint;
out float acrossByDepth;                // linear on screen once divided: gl_FragCoord.w is 1/w
out float halfByDepth;
void main() {
    vec4 a = projection * vec4(from, 1);
    vec4 b = projection * vec4(to, 1);
    vec2 along = (b.xy / b.w - a.xy / a.w) * halfSize;
    float reach = length(along);
    along = reach > 1e-6 ? along / reach : vec2(1, 0);
    float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    bool first = gl_VertexID < 2;
    float halfWidth = 0.5 * (first ? width.x : width.y);
    float across = side * (halfWidth + 1.0);
    vec4 p = first ? a : b;
    acrossByDepth = across * p.w;
    halfByDepth = halfWidth * p.w;
    p.xy += vec2(-along.y, along.x) * across / halfSize * p.w;
    p.z -= nearer * p.w;
    tint = first ? colorFrom : colorTo;
    gl_Position = p;
}
)";

inline constexpr const char* lineFragmentShader = R"(#version 330 core
in vec4 tint;
in float acrossByDepth;
in float halfByDepth;
uniform float opacity;
out vec4 pixel;
void main() {
    float across = acrossByDepth * gl_FragCoord.w;
    float halfWidth = halfByDepth * gl_FragCoord.w;
    float cover = clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0) * min(2.0 * halfWidth, 1.0);
    if (cover <= 0.0)
        discard;
    pixel = vec4(tint.rgb, opacity * tint.a * cover);
}
)";

inline constexpr const char* discVertexShader = R"(#version 330 core
layout(location = 0) in vec3 middle;
layout(location = 1) in vec4 fill;      // sRGB, not premultiplied
layout(location = 2) in vec4 rim;
layout(location = 3) in vec2 radius;    // outer; width of the rim: pixels
uniform mat4 projection;
uniform vec2 halfSize;                  // of the picture, pixels
out vec2 away;                          // from the middle, pixels
flat out vec4 inner;
flat out vec4 outer;
flat out vec2 reach;
void main() {
    vec2 side = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    vec4 p = projection * vec4(middle, 1);
    away = side * (radius.x + 1.0);
    p.xy += away / halfSize * p.w;
    inner = fill;
    outer = rim;
    reach = radius;
    gl_Position = p;
}
)";

inline constexpr const char* discFragmentShader = R"(#version 330 core
in vec2 away;
flat in vec4 inner;
flat in vec4 outer;
flat in vec2 reach;
uniform float opacity;
out vec4 pixel;
void main() {
    float from = length(away);
    float cover = clamp(reach.x + 0.5 - from, 0.0, 1.0);
    if (cover <= 0.0)
        discard;
    vec4 c = mix(inner, outer, clamp(from - (reach.x - reach.y) + 0.5, 0.0, 1.0));
    pixel = vec4(c.rgb, opacity * c.a * cover);
}
)";

// Bands of colour across the picture; a grain of half a step hides where one shade ends.
inline constexpr const char* backdropVertexShader = R"(#version 330 core
layout(location = 0) in vec2 corner;    // clip space
layout(location = 1) in vec3 shade;
out vec3 tint;
void main() {
    tint = shade;
    gl_Position = vec4(corner, 0.999999, 1);
}
)";

inline constexpr const char* backdropFragmentShader = R"(#version 330 core
in vec3 tint;
out vec4 pixel;
void main() {
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    pixel = vec4(tint + (grain - 0.5) / 255.0, 1);
}
)";

} // namespace render
