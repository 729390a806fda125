#include "window/offscreen.h"

#include "core/error.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <string>
#include <utility>
#include <vector>

namespace penumbra {

struct Offscreen::Parts {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~Parts() {
        if (display == EGL_NO_DISPLAY)
            return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT)
            eglDestroyContext(display, context);
        eglTerminate(display);
    }
};

Offscreen::Offscreen() : parts_(std::make_unique<Parts>()) {
    const auto require = [](bool ok, const char *what) {
        if (!ok)
            throw Unavailable(std::string("no off-screen drawing here: ") + what +
                              "; a software driver will do (Debian: libegl1 and libgl1-mesa-dri)");
    };
    require(epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"),
            "EGL has no surfaceless platform");
    parts_->display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EGLint major = 0, minor = 0;
    require(parts_->display != EGL_NO_DISPLAY && eglInitialize(parts_->display, &major, &minor) == EGL_TRUE,
            "EGL does not start");
    require(eglBindAPI(EGL_OPENGL_API) == EGL_TRUE, "EGL has no desktop OpenGL");
    std::vector<EGLint> wanted{EGL_CONTEXT_MAJOR_VERSION,       4, EGL_CONTEXT_MINOR_VERSION,           1,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
    const auto make = [&](std::vector<EGLint> attributes) {
        attributes.push_back(EGL_NONE);
        return eglCreateContext(parts_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    };
    if (major > 1 || minor >= 5) { // so that a lost context is told of, where the driver can
        std::vector<EGLint> robust = wanted;
        robust.insert(robust.end(), {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
        parts_->context = make(std::move(robust));
    }
    if (parts_->context == EGL_NO_CONTEXT)
        parts_->context = make(std::move(wanted));
    require(parts_->context != EGL_NO_CONTEXT, "the driver has no OpenGL 4.1 core");
    require(eglMakeCurrent(parts_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, parts_->context) == EGL_TRUE,
            "the context cannot be made current");
}

Offscreen::~Offscreen() = default;

} // namespace penumbra
