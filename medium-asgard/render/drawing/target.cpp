#include "drawing/target.h"

#include <algorithm>

namespace render {

Target::~Target() { drop(); }

void Target::drop() {
    gl_.DeleteFramebuffers(1, &drawing_);
    gl_.DeleteFramebuffers(1, &resolved_);
    gl_.DeleteRenderbuffers(1, &color_);
    gl_.DeleteRenderbuffers(1, &depth_);
    gl_.DeleteRenderbuffers(1, &resolvedColor_);
    drawing_ = color_ = depth_ = resolved_ = resolvedColor_ = 0;
    size_ = {0, 0};
}

bool Target::prepare(Size size, int samples) {
    if (size == size_ && samples == asked_) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, drawing_);
        return true;
    }
    GLint most = 1;
    gl_.GetIntegerv(GL_MAX_SAMPLES, &most);
    asked_ = samples;
    for (int n = std::clamp<int>(samples, 1, std::max(1, most)); n >= 1; n /= 2)
        if (make(size, n))
            return true;
    return false;
}

bool Target::make(Size size, int samples) {
    drop();
    const auto storage = [&](GLuint& buffer, GLenum format, int count) {
        gl_.GenRenderbuffers(1, &buffer);
        gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
        if (count > 1)
            gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, count, format, size.width,
                                               size.height);
        else
            gl_.RenderbufferStorage(GL_RENDERBUFFER, format, size.width, size.height);
    };
    const auto complete = [&](GLuint& framebuffer, GLuint color, GLuint depth) {
        gl_.GenFramebuffers(1, &framebuffer);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                    depth);
        return gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    };
    while (gl_.GetError() != GL_NO_ERROR) {
    }
    if (samples > 1) {
        storage(resolvedColor_, GL_RGBA8, 1);
        if (!complete(resolved_, resolvedColor_, 0))
            return false;
    }
    storage(color_, GL_RGBA8, samples);
    storage(depth_, GL_DEPTH24_STENCIL8, samples);
    if (!complete(drawing_, color_, depth_) || gl_.GetError() != GL_NO_ERROR)
        return false;
    size_ = size;
    samples_ = samples;
    return true;
}

void Target::read(const Image& into) const {
    if (resolved_ != 0) {
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawing_);
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
        gl_.BlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height,
                            GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_ != 0 ? resolved_ : drawing_);
    gl_.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    const auto rows = [&](int from, int count, std::byte* to) {
        gl_.ReadPixels(0, from, size_.width, count, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, to);
    };
    if (into.stride % 4 == 0) {
        gl_.PixelStorei(GL_PACK_ROW_LENGTH, static_cast<GLint>(into.stride / 4));
        rows(0, size_.height, into.pixels.data());
        gl_.PixelStorei(GL_PACK_ROW_LENGTH, 0);
        return;
    }
    for (int y = 0; y < size_.height; ++y)
        rows(y, 1, into.pixels.data() + static_cast<std::size_t>(y) * into.stride);
}

} // namespace render
