#include "app/offscreen/OsMesaContext.h"

#include <GL/osmesa.h>

#include <array>

#include "app/offscreen/GlxNames.h"

namespace vestige {

AnyFunction glFunction(const char* name) {
    return reinterpret_cast<AnyFunction>(OSMesaGetProcAddress(name));
}

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
