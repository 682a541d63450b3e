#include "core/io/formats/PntsHeader.h"

#include <algorithm>
#include <cstdint>

#include "core/io/Bytes.h"

namespace vestige {

PntsHeader parsePntsHeader(std::span<const std::byte> bytes, bool salvage, ReadJob& job) {
    if (bytes.size() < kPntsHeaderBytes)
        job.refuseByte(bytes.size(), "the file ends inside the header of the point tile",
                       std::to_string(kPntsHeaderBytes) + " bytes");
    const auto word = [&](std::size_t at) { return load<std::uint32_t>(bytes.data() + at); };
    if (textOf(bytes, {0, 4}) != "pnts") job.refuseByte(0, "this is no point tile", "\"pnts\"");
    if (word(4) != 1) job.refuseByte(4, "the point tile has version " + std::to_string(word(4)), "version 1");
    PntsHeader header;
    const std::size_t length = word(8);
    std::size_t end = kPntsHeaderBytes;
    std::size_t field = 12;
    for (PntsSection* section :
         {&header.featureJson, &header.featureBinary, &header.batchJson, &header.batchBinary}) {
        *section = {end, word(field)};
        end += section->length;
        if (end > length)
            job.refuseByte(field,
                           "the sections of the point tile end at byte " + std::to_string(end) +
                               ", the tile at byte " + std::to_string(length),
                           "sections within the tile");
        field += 4;
    }
    header.truncated = length > bytes.size();
    if (header.truncated && !salvage)
        job.refuseByte(bytes.size(), "the file ends inside the point tile",
                       std::to_string(length) + " bytes, as its header says");
    if (length < bytes.size())
        job.warn(counted(bytes.size() - length, "byte") + " after the end of the point tile passed over");
    if (header.featureJson.begin + header.featureJson.length > bytes.size())
        job.refuseByte(bytes.size(), "the file ends inside the feature table",
                       counted(header.featureJson.length, "byte") + " of JSON");
    header.batchTableCut = header.batchJson.begin + header.batchJson.length > bytes.size();
    for (PntsSection* section : {&header.featureBinary, &header.batchJson, &header.batchBinary}) {
        section->begin = std::min(section->begin, bytes.size());
        section->length = std::min(section->length, bytes.size() - section->begin);
    }
    return header;
}

}  // namespace vestige
