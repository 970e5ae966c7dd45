// The two shader programs: solids (instanced meshes, lit) and lines (segments widened on screen).
//
// Everything is in view coordinates (render/camera.h), transformed in double precision before it
// gets here, so that a scene far from the origin does not tremble. Light is added up linearly and
// encoded as sRGB by the fragment shader; blending and resolving then happen in the encoded space,
// where equal steps look equal.
#pragma once

namespace render {

inline constexpr int mostLights = 8;

inline constexpr const char* solidVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 row0;      // mesh to view, three rows
layout(location = 3) in vec4 row1;
layout(location = 4) in vec4 row2;
layout(location = 5) in vec4 color;     // linear; alpha 1 is opaque
layout(location = 6) in vec2 material;  // shininess; depth of the quarters of a spinning ball
uniform mat4 projection;
uniform vec4 ground;                    // unit normal and offset of the ground plane
uniform int pass;                       // 0 surfaces, 1 shadows on the ground, 2 faces along it
out vec3 place;
out vec3 facing;
out vec3 local;
out float height;
flat out vec4 tint;
flat out vec2 surface;
void main() {
    vec4 p = vec4(position, 1);
    place = vec3(dot(row0, p), dot(row1, p), dot(row2, p));
    facing = vec3(dot(row0.xyz, normal), dot(row1.xyz, normal), dot(row2.xyz, normal));
    local = position;
    tint = color;
    surface = material;
    height = dot(ground.xyz, place) - ground.w;
    if (pass == 1)
        place -= height * ground.xyz;
    gl_Position = projection * vec4(place, 1);
}
)";

inline constexpr const char* solidFragmentShader = R"(#version 330 core
in vec3 place;
in vec3 facing;
in vec3 local;
in float height;
flat in vec4 tint;
flat in vec2 surface;
uniform int pass;
uniform vec4 ground;
uniform float reach;                    // height at which a shadow has faded to a third
uniform vec3 up;
uniform float eye;                      // distance of the eye from view z = 0
uniform int lights;
uniform vec4 lightPlace[8];             // w 0: unit direction towards it; 1: where it stands
uniform vec3 lightColor[8];
out vec4 pixel;

vec3 encoded(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

void main() {
    if (pass == 1) {
        if (height < 1e-3 * reach)
            discard;
        pixel = vec4(0.10, 0.12, 0.16, 0.24 * exp(-height / reach));
        return;
    }
    vec3 n = normalize(facing);
    if (pass == 2) {
        if (dot(n, ground.xyz) < 0.999 || abs(height) > 1e-3 * reach)
            discard;
        pixel = vec4(0);
        return;
    }
    if (!gl_FrontFacing)
        n = -n;
    vec3 toEye = normalize(vec3(0, 0, eye) - place);
    // A little light from everywhere, more from above: no face is black, and no two faces alike.
    float sky = 0.5 + 0.5 * dot(n, up);
    vec3 diffuse = mix(vec3(0.185, 0.19, 0.21), vec3(0.42, 0.42, 0.41), sky);
    vec3 gloss = vec3(0);
    float power = mix(6.0, 160.0, surface.x * surface.x);
    for (int i = 0; i < lights; ++i) {
        vec3 toLight = lightPlace[i].w > 0.5 ? normalize(lightPlace[i].xyz - place) : lightPlace[i].xyz;
        float cosine = dot(n, toLight);
        if (cosine > 0.0) {
            diffuse += cosine * lightColor[i];
            float mirrored = max(dot(n, normalize(toLight + toEye)), 0.0);
            gloss += pow(mirrored, power) * min(4.0 * cosine, 1.0) * lightColor[i];
        }
    }
    vec3 albedo = tint.rgb;
    if (surface.y > 0.0) {
        // Opposite quarters of a ball that turns are a shade darker, with a soft seam.
        float seam = local.x * local.y;
        float width = max(fwidth(seam), 1e-4);
        albedo *= 1.0 - surface.y * smoothstep(-width, width, seam);
    }
    vec3 c = albedo * diffuse + 0.45 * surface.x * gloss;
    // Too much light keeps its hue instead of turning white.
    c /= max(1.0, max(c.r, max(c.g, c.b)) * 0.5 + 0.5);
    pixel = vec4(encoded(c), tint.a);
}
)";

inline constexpr const char* lineVertexShader = R"(#version 330 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colorFrom; // sRGB, not premultiplied
layout(location = 3) in vec4 colorTo;
layout(location = 4) in float width;    // pixels
uniform mat4 projection;
uniform vec2 halfSize;                  // of the picture, pixels
uniform float nearer;                   // moved towards the eye, in depth
out vec4 tint;
out float acrossByDepth;                // linear on screen once divided: gl_FragCoord.w is 1/w
flat out float halfWidth;
void main() {
    vec4 a = projection * vec4(from, 1);
    vec4 b = projection * vec4(to, 1);
    vec2 along = (b.xy / b.w - a.xy / a.w) * halfSize;
    float reach = length(along);
    along = reach > 1e-6 ? along / reach : vec2(1, 0);
    float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
    bool first = gl_VertexID < 2;
    halfWidth = 0.5 * width;
    float across = side * (halfWidth + 1.0);
    vec4 p = first ? a : b;
    acrossByDepth = across * p.w;
    p.xy += vec2(-along.y, along.x) * across / halfSize * p.w;
    p.z -= nearer * p.w;
    tint = first ? colorFrom : colorTo;
    gl_Position = p;
}
)";

inline constexpr const char* lineFragmentShader = R"(#version 330 core
in vec4 tint;
in float acrossByDepth;
flat in float halfWidth;
out vec4 pixel;
void main() {
    float across = acrossByDepth * gl_FragCoord.w;
    float cover = clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0) * min(2.0 * halfWidth, 1.0);
    if (cover <= 0.0)
        discard;
    pixel = vec4(tint.rgb, tint.a * cover);
}
)";

} // namespace render
