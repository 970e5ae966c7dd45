#include "drawing/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace render {

namespace {

// Two directions across one, and that one.
Eigen::Matrix3d basisOf(const Vector& toLight) {
    Eigen::Matrix3d rows;
    const Vector across = toLight.unitOrthogonal();
    rows << across.transpose(), toLight.cross(across).transpose(), toLight.transpose();
    return rows;
}

// In the light's axes: the solids, and of them only what the room's shadows can come from.
Eigen::AlignedBox3d boundsOf(std::span<const Solid> solids, const Eigen::AlignedBox3d& room,
                             const Eigen::Matrix3d& axes) {
    Eigen::AlignedBox3d seen, all;
    for (int i = 0; i < 8; ++i)
        seen.extend(Vector(axes * room.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i))));
    for (const Solid& solid : solids) {
        const Vector middle = axes * solid.middle;
        const Eigen::AlignedBox3d ball(Vector(middle.array() - solid.radius),
                                       Vector(middle.array() + solid.radius));
        const bool beside = (ball.min().head<2>().array() > seen.max().head<2>().array()).any() ||
                            (ball.max().head<2>().array() < seen.min().head<2>().array()).any();
        if (!beside)
            all.extend(ball);
    }
    if (all.isEmpty())
        return all;
    all.min().head<2>() = all.min().head<2>().cwiseMax(seen.min().head<2>());
    all.max().head<2>() = all.max().head<2>().cwiseMin(seen.max().head<2>());
    return all;
}

std::optional<LightSight> fromAfar(const Vector& toLight, std::span<const Solid> solids,
                                   const Eigen::AlignedBox3d& room, int texels) {
    const Eigen::Matrix3d axes = basisOf(toLight);
    Eigen::AlignedBox3d bounds = boundsOf(solids, room, axes);
    if (bounds.isEmpty())
        return std::nullopt;
    // A rim, so that what is beside the map is lit.
    const Vector rim = Vector::Constant(4.0 / texels * bounds.sizes().head<2>().maxCoeff() + 1e-9);
    bounds.min() -= rim;
    bounds.max() += rim;
    const Vector middle = bounds.center(), half = bounds.sizes() / 2;
    LightSight sight;
    sight.texel = 2 * half.head<2>().maxCoeff() / texels;
    sight.matrix.setIdentity();
    for (int row = 0; row < 3; ++row) {
        const double sign = row == 2 ? -1 : 1; // depth grows away from the light
        sight.matrix.row(row).head<3>() = sign * axes.row(row) / half[row];
        sight.matrix(row, 3) = -sign * middle[row] / half[row];
    }
    return sight;
}

std::optional<LightSight> fromPlace(const Vector& place, std::span<const Solid> solids,
                                    int texels) {
    Eigen::AlignedBox3d box;
    for (const Solid& solid : solids) {
        box.extend(Vector(solid.middle.array() - solid.radius));
        box.extend(Vector(solid.middle.array() + solid.radius));
    }
    if (box.isEmpty())
        return std::nullopt;
    const double radius = box.sizes().norm() / 2, distance = (place - box.center()).norm();
    if (distance < 1.02 * radius)
        return std::nullopt;
    const Eigen::Matrix3d axes = basisOf((place - box.center()) / distance);
    // With the distance d = -z from the light: clip x = f x, clip w = d.
    const double near = distance - radius, far = distance + radius;
    const double slope = radius / std::sqrt(distance * distance - radius * radius) * 1.01;
    LightSight sight;
    sight.texel = 2 * slope * far / texels;
    Eigen::Matrix4d toLight = Eigen::Matrix4d::Identity(), clip = Eigen::Matrix4d::Zero();
    toLight.topLeftCorner<3, 3>() = axes;
    toLight.topRightCorner<3, 1>() = -axes * place;
    clip(0, 0) = clip(1, 1) = 1 / slope;
    clip(2, 2) = -(far + near) / (far - near);
    clip(2, 3) = -2 * far * near / (far - near);
    clip(3, 2) = -1;
    sight.matrix = clip * toLight;
    return sight;
}

} // namespace

std::vector<Solid> throwingShadows(std::span<const Solid> solids) {
    std::vector<Solid> throwing;
    std::ranges::copy_if(solids, std::back_inserter(throwing), [](const Solid& solid) {
        return !std::holds_alternative<scene::PlaneShape>(solid.part->shape);
    });
    return throwing;
}

std::optional<LightSight> sightOf(const Light& light, std::span<const Solid> solids,
                                  const Eigen::AlignedBox3d& room, int texels) {
    return light.isPoint ? fromPlace(light.place, solids, texels)
                         : fromAfar(light.place, solids, room, texels);
}

Eigen::AlignedBox3d visibleRoom(const Frame& frame, double nearestZ, double furthestZ) {
    const double units = 2 * pixelsPerUnit(frame.size());
    Eigen::AlignedBox3d room;
    for (const double z : {std::min(nearestZ, eyeDistance - 0.02), furthestZ}) {
        const double wider = 1 / enlargement(frame.camera(), z) / units;
        const Vector corner(frame.size().width * wider, frame.size().height * wider, z);
        room.extend(corner);
        room.extend(Vector(-corner.x(), -corner.y(), z));
    }
    return room;
}

ShadowMap::~ShadowMap() {
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteTextures(1, &texture_);
}

bool ShadowMap::begin(int texels) {
    if (framebuffer_ == 0) {
        gl_.GenFramebuffers(1, &framebuffer_);
        gl_.GenTextures(1, &texture_);
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    if (texels != texels_) {
        const float lit[] = {1, 1, 1, 1};
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, mostShadowMaps * texels, texels, 0,
                       GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
        gl_.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
        gl_.DrawBuffer(GL_NONE);
        gl_.ReadBuffer(GL_NONE);
        if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            return false;
        texels_ = texels;
    }
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthMask(GL_TRUE);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    gl_.FrontFace(GL_CCW); // the picture alone is upside down
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(1.5F, 2);
    return true;
}

void ShadowMap::bind(std::size_t map) {
    gl_.Viewport(static_cast<GLint>(map) * texels_, 0, texels_, texels_);
}

void ShadowMap::end() {
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(1, 1);
    gl_.FrontFace(GL_CW);
}

} // namespace render
