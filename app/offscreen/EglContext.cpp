// For bench_view_gpu alone, and no part of the library: what OsMesaContext.cpp is for OSMesa, for the driver
// of a graphics card, by EGL and without a display.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdio>

#include "app/offscreen/GlxNames.h"
#include "app/offscreen/OsMesaContext.h"

namespace vestige {

AnyFunction glFunction(const char* name) {
    return eglGetProcAddress(name);
}

namespace {

class EglContext : public GlContext {
  public:
    EglContext(EGLDisplay display, EGLContext context, EGLSurface surface)
        : display_(display), context_(context), surface_(surface) {}
    ~EglContext() override {
        eglDestroyContext(display_, context_);
        eglDestroySurface(display_, surface_);
    }
    bool makeCurrent() override {
        return isCurrent() || eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE;
    }
    bool isCurrent() const override { return eglGetCurrentContext() == context_; }

  private:
    EGLDisplay display_;
    EGLContext context_;
    EGLSurface surface_;
};

/// The first device that gives one.
EGLDisplay deviceDisplay() {
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto platformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!queryDevices || !platformDisplay) return EGL_NO_DISPLAY;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE)
        return EGL_NO_DISPLAY;
    for (EGLint i = 0; i < count; ++i) {
        const EGLDisplay display =
            platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
    }
    return EGL_NO_DISPLAY;
}

}  // namespace

std::unique_ptr<GlContext> osMesaContext() {
    static const EGLDisplay display = deviceDisplay();
    if (display == EGL_NO_DISPLAY || eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
        std::fprintf(stderr, "no device gives an EGL display\n");
        return nullptr;
    }
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &count) != EGL_TRUE || count == 0) return nullptr;
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              2,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    if (context == EGL_NO_CONTEXT) return nullptr;
    const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    auto made =
        std::make_unique<EglContext>(display, context, eglCreatePbufferSurface(display, config, size));
    const auto text = reinterpret_cast<const unsigned char* (*)(unsigned)>(eglGetProcAddress("glGetString"));
    constexpr unsigned kRenderer = 0x1f01;
    if (made->makeCurrent() && text)
        std::printf("drawn by %s\n", reinterpret_cast<const char*>(text(kRenderer)));
    return made;
}

}  // namespace vestige
