// vestige-import: reads one file with a foreign library for Vestige, which starts it, limits it and takes its
// output (core/io/importer). It reads the descriptors that it is given and opens nothing.
//
// vestige-import FORMAT MEMORY_BYTES SECONDS
#include <unistd.h>

#include <new>
#include <string>

#include "app/importer/GltfMeshes.h"
#include "app/importer/Limits.h"
#include "app/importer/Streams.h"
#include "app/importer/ThreeMfModel.h"
#include "core/base/Numbers.h"
#include "core/io/importer/ImporterProtocol.h"

namespace {

int import(const std::string& format) {
    using namespace vestige;
    ImportSender sender(importer::send);
    try {
        if (format == "3mf")
            importer::sendThreeMf(importer::mapped(3), sender);
        else if (format == "gltf")
            importer::sendGltf(importer::readAll(STDIN_FILENO), sender);
        else
            return 2;
        sender.end();
        return 0;
    } catch (const std::bad_alloc&) {
        return kImporterOutOfMemory;
    } catch (const ErrorException& thrown) {
        sender.refusal(thrown.error.message, thrown.error.hint);
    } catch (const std::exception& thrown) {
        sender.refusal(thrown.what(), "a whole and valid file of this format");
    }
    return 3;
}

}  // namespace

int main(int count, char** words) {
    if (count != 4) return 2;
    const auto memory = vestige::parseInteger(words[2]);
    const auto seconds = vestige::parseInteger(words[3]);
    if (!memory || !seconds || *memory < 0 || *seconds < 0) return 2;
    vestige::importer::limitProcess(static_cast<std::uint64_t>(*memory),
                                    static_cast<std::uint64_t>(*seconds));
    vestige::importer::closeDoors();
    // Nothing of the libraries needs tidying up.
    ::_exit(import(words[1]));
}
