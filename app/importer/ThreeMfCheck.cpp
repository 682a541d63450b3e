#include "app/importer/ThreeMfCheck.h"

#include <lib3mf/Model/COM/NMR_DLLInterfaces.h>
// After the types that it needs.
#include <lib3mf/Common/NMR_ErrorConst.h>

#include <set>

#include "core/base/Result.h"

namespace vestige::importer {
namespace {

constexpr const char* kExpected = "a 3MF file that keeps the specification";

/// Releases an object of lib3mf when it goes.
struct Handle {
    NMR::PLib3MFBase* object = nullptr;
    Handle() = default;
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (object) NMR::lib3mf_release(object);
    }
};

void check(LIB3MFRESULT result, NMR::PLib3MFBase* speaker) {
    if (result == LIB3MF_OK) return;
    DWORD code = 0;
    LPCSTR text = nullptr;
    std::string sentence = "lib3mf refuses the file";
    if (speaker && NMR::lib3mf_getlasterror(speaker, &code, &text) == LIB3MF_OK && text && *text)
        sentence += ": " + std::string(text);
    throw ErrorException{{ErrorCode::input, sentence, {}, kExpected}};
}

/// Some writers use a name prefix that they never declare; lib3mf then gives up on the whole part.
bool lacksPrefix(NMR::PLib3MFBase* reader) {
    DWORD code = 0;
    LPCSTR text = nullptr;
    return NMR::lib3mf_getlasterror(reader, &code, &text) == LIB3MF_OK &&
           (code == NMR_ERROR_COULDNOTGETNAMESPACE || code == NMR_ERROR_XMLPARSER_INVALIDNAMESPACEPREFIX);
}

void collectWarnings(NMR::PLib3MFModelReader* reader, std::vector<std::string>& warnings) {
    constexpr DWORD kMost = 32;
    std::set<std::string> said;
    DWORD count = 0;
    if (NMR::lib3mf_reader_getwarningcount(reader, &count) != LIB3MF_OK) return;
    for (DWORD i = 0; i < count && i < kMost; ++i) {
        char text[256] = {};
        DWORD code = 0;
        ULONG needed = 0;
        if (NMR::lib3mf_reader_getwarningutf8(reader, i, &code, text, sizeof(text), &needed) == LIB3MF_OK)
            said.insert("lib3mf warns: " + std::string(text));
    }
    warnings.assign(said.begin(), said.end());
}

}  // namespace

ThreeMfVerdict checkThreeMf(std::span<const std::byte> file) {
    Handle model, reader, iterator;
    check(NMR::lib3mf_createmodel(&model.object), nullptr);
    check(NMR::lib3mf_model_queryreader(model.object, "3mf", &reader.object), model.object);
    auto* bytes = reinterpret_cast<BYTE*>(const_cast<std::byte*>(file.data()));
    const LIB3MFRESULT result = NMR::lib3mf_reader_readfrombuffer(reader.object, bytes, file.size());
    ThreeMfVerdict verdict;
    if (result != LIB3MF_OK && lacksPrefix(reader.object)) {
        verdict.warnings.emplace_back("a name prefix is used but not declared; lib3mf cannot check the file");
        verdict.given = false;
        return verdict;
    }
    check(result, reader.object);
    collectWarnings(reader.object, verdict.warnings);
    check(NMR::lib3mf_model_getmeshobjects(model.object, &iterator.object), model.object);
    for (;;) {
        BOOL more = 0;
        check(NMR::lib3mf_resourceiterator_movenext(iterator.object, &more), iterator.object);
        if (!more) break;
        Handle mesh;
        check(NMR::lib3mf_resourceiterator_getcurrent(iterator.object, &mesh.object), iterator.object);
        DWORD vertices = 0, triangles = 0;
        check(NMR::lib3mf_meshobject_getvertexcount(mesh.object, &vertices), mesh.object);
        check(NMR::lib3mf_meshobject_gettrianglecount(mesh.object, &triangles), mesh.object);
        verdict.vertices += vertices;
        verdict.triangles += triangles;
    }
    return verdict;
}

}  // namespace vestige::importer
