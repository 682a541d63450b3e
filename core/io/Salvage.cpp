#include "core/io/Salvage.h"

namespace vestige {

std::string damageSentence(const ReadJob& job, const Error& error, std::size_t points) {
    const std::string file = job.place() + ", ";
    const std::string where =
        error.place.starts_with(file) ? " at " + error.place.substr(file.size()) : std::string();
    return "The file is damaged" + where + " (" + error.message + "); the " + counted(points, "point") +
           " before that were read.";
}

}  // namespace vestige
