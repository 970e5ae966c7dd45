#include "drawing/context.h"

#include <EGL/eglext.h>

#include <cstdlib>
#include <string_view>
#include <vector>

namespace render {

namespace {

bool initialised(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
}

EGLDisplay deviceDisplay(PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay) {
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    if (queryDevices == nullptr)
        return EGL_NO_DISPLAY;
    std::vector<EGLDeviceEXT> devices(16);
    EGLint count = 0;
    if (queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE)
        return EGL_NO_DISPLAY;
    devices.resize(static_cast<std::size_t>(count));
    for (EGLDeviceEXT device : devices)
        if (EGLDisplay display = getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
            initialised(display))
            return display;
    return EGL_NO_DISPLAY;
}

EGLDisplay openDisplay() {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const std::string_view known = extensions == nullptr ? "" : extensions;
    const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (getPlatformDisplay == nullptr)
        return EGL_NO_DISPLAY;
    if (known.find("EGL_MESA_platform_surfaceless") != std::string_view::npos)
        if (EGLDisplay display =
                getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
            initialised(display))
            return display;
    return deviceDisplay(getPlatformDisplay);
}

EGLContext openContext(EGLDisplay display) {
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE)
        return EGL_NO_CONTEXT;
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
}

} // namespace

std::variant<std::unique_ptr<Context>, std::string> Context::create() {
    // Else Mesa writes compiled shaders into the user's home, which a confined process must not.
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
    EGLDisplay display = openDisplay();
    if (display == EGL_NO_DISPLAY)
        return "There is no EGL driver that draws without a display: "
               "install libegl1 and libgl1-mesa-dri.";
    EGLContext context = openContext(display);
    if (context == EGL_NO_CONTEXT)
        return "The graphics driver has no OpenGL 3.3 core profile: install libgl1-mesa-dri.";
    std::unique_ptr<Context> made(new Context(display, context));
    if (!made->makeCurrent())
        return "The graphics driver cannot draw without a window (no surfaceless contexts): "
               "install libgl1-mesa-dri.";
    return made;
}

// The display stays initialised: other contexts of this process share it.
Context::~Context() {
    if (eglGetCurrentContext() == context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

bool Context::makeCurrent() const {
    if (eglGetCurrentContext() == context_)
        return true;
    return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
}

} // namespace render
