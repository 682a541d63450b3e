#pragma once

// VTK here is built for GLX: its loader (GLEW) asks the process for these names. Answered by the program they
// lead to the library that gives its context; libGL's own would look for an X server. Included by one file of
// a program, the one of its context.
#include <cstring>

namespace vestige {
using AnyFunction = void (*)();
/// An OpenGL function by its name, of the library that gives the context.
AnyFunction glFunction(const char* name);
}  // namespace vestige

#define VESTIGE_EXPORT extern "C" __attribute__((visibility("default")))

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

VESTIGE_EXPORT vestige::AnyFunction glXGetProcAddressARB(const unsigned char* name) {
    const char* wanted = reinterpret_cast<const char*>(name);
    if (!std::strcmp(wanted, "glXGetCurrentDisplay"))
        return reinterpret_cast<vestige::AnyFunction>(glXGetCurrentDisplay);
    if (!std::strcmp(wanted, "glXQueryVersion"))
        return reinterpret_cast<vestige::AnyFunction>(glXQueryVersion);
    if (!std::strcmp(wanted, "glXGetClientString"))
        return reinterpret_cast<vestige::AnyFunction>(glXGetClientString);
    return vestige::glFunction(wanted);
}

VESTIGE_EXPORT vestige::AnyFunction glXGetProcAddress(const unsigned char* name) {
    return glXGetProcAddressARB(name);
}
