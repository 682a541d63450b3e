#include "app/offscreen/OsMesaContext.h"

#include <GL/osmesa.h>

#include <array>
#include <cstring>

// VTK here is built for GLX: its loader (GLEW) asks the process for these four names. Answered by this
// program they lead to OSMesa; libGL's own would look for an X server.
#define VESTIGE_EXPORT extern "C" __attribute__((visibility("default")))
using AnyFunction = void (*)();

VESTIGE_EXPORT void* glXGetCurrentDisplay() {
    static int display = 0;
    return &display;
}

VESTIGE_EXPORT int glXQueryVersion(void*, int* major, int* minor) {
    *major = 1;
    *minor = 4;
    return 1;
}

VESTIGE_EXPORT const char* glXGetClientString(void*, int) {
    return "";
}

VESTIGE_EXPORT AnyFunction glXGetProcAddressARB(const unsigned char* name) {
    const char* wanted = reinterpret_cast<const char*>(name);
    if (!std::strcmp(wanted, "glXGetCurrentDisplay"))
        return reinterpret_cast<AnyFunction>(glXGetCurrentDisplay);
    if (!std::strcmp(wanted, "glXQueryVersion")) return reinterpret_cast<AnyFunction>(glXQueryVersion);
    if (!std::strcmp(wanted, "glXGetClientString")) return reinterpret_cast<AnyFunction>(glXGetClientString);
    return reinterpret_cast<AnyFunction>(OSMesaGetProcAddress(wanted));
}

VESTIGE_EXPORT AnyFunction glXGetProcAddress(const unsigned char* name) {
    return glXGetProcAddressARB(name);
}

namespace vestige {
namespace {

class OsMesaContext : public GlContext {
  public:
    explicit OsMesaContext(OSMesaContext context) : context_(context) {}
    ~OsMesaContext() override { OSMesaDestroyContext(context_); }

    bool makeCurrent() override {
        return isCurrent() ||
               OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_TRUE;
    }
    bool isCurrent() const override { return OSMesaGetCurrentContext() == context_; }

  private:
    // VTK draws into its own framebuffers; OSMesa only insists on having one too.
    static constexpr int kSide = 16;
    OSMesaContext context_;
    std::array<unsigned char, std::size_t{4} * kSide * kSide> pixels_{};
};

}  // namespace

std::unique_ptr<GlContext> osMesaContext() {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              2,
                              0};
    const OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context) return nullptr;
    return std::make_unique<OsMesaContext>(context);
}

}  // namespace vestige
