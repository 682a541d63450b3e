#include "core/io/formats/E57WriteXml.h"

#include "core/base/Hash.h"
#include "core/base/Numbers.h"
#include "core/base/Version.h"
#include "core/io/formats/E57PageWriter.h"
#include "core/io/formats/E57Time.h"

namespace vestige {
namespace {

/// The length of a UTF-8 sequence at `at`; 0 where there is none that XML may hold.
std::size_t sequenceAt(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const unsigned first = byte(at);
    if (first < 0x80) return first >= ' ' || first == '\t' || first == '\n' ? 1 : 0;
    const std::size_t length = first >= 0xf0 && first < 0xf5 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
    if (first >= 0xf5) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(at + i) & 0xc0) != 0x80) return 0;
    return length;
}

/// As character data that any parser reads back.
std::string quoted(const std::string& text) {
    std::string clean;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = sequenceAt(text, at);
        clean += length == 0 ? "?" : text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
    for (std::size_t at = 0; (at = clean.find("]]>", at)) != std::string::npos; at += 12)
        clean.replace(at, 3, "]]]]><![CDATA[>");
    return "<![CDATA[" + clean + "]]>";
}

/// {8-4-4-4-12} of the hash of a text: the same for the same text.
std::string guidOf(const std::string& text) {
    Sha256 hash;
    hash.add(text);
    const std::string digits = hash.hex();
    return "{" + digits.substr(0, 8) + "-" + digits.substr(8, 4) + "-" + digits.substr(12, 4) + "-" +
           digits.substr(16, 4) + "-" + digits.substr(20, 12) + "}";
}

class XmlWriter {
  public:
    void open(const std::string& name, const std::string& attributes) {
        line("<" + name + " " + attributes + ">");
        open_.push_back(name);
    }
    void structure(const std::string& name) { open(name, "type=\"Structure\""); }
    void vector(const std::string& name) { open(name, "type=\"Vector\" allowHeterogeneousChildren=\"1\""); }
    void close() {
        const std::string name = open_.back();
        open_.pop_back();
        line("</" + name + ">");
    }
    void leaf(const std::string& name, const std::string& attributes, const std::string& value) {
        line("<" + name + " " + attributes + (value.empty() ? "/>" : ">" + value + "</" + name + ">"));
    }
    void text(const std::string& name, const std::string& value) {
        if (!value.empty()) leaf(name, "type=\"String\"", quoted(value));
    }
    void real(const std::string& name, double value) { leaf(name, "type=\"Float\"", exactText(value)); }
    void integer(const std::string& name, std::int64_t value) {
        leaf(name, "type=\"Integer\"", std::to_string(value));
    }
    void line(const std::string& content) { text_ += std::string(2 * open_.size(), ' ') + content + "\n"; }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
    std::vector<std::string> open_;
};

void writeTime(XmlWriter& xml, const std::string& name, double seconds) {
    xml.structure(name);
    xml.real("dateTimeValue", seconds);
    xml.integer("isAtomicClockReferenced", 0);
    xml.close();
}

void writePose(XmlWriter& xml, const Pose& pose) {
    if (pose.matrix() == Eigen::Matrix4d::Identity()) return;
    const Eigen::Quaterniond rotation(pose.linear());
    xml.structure("pose");
    xml.structure("rotation");
    xml.real("w", rotation.w());
    xml.real("x", rotation.x());
    xml.real("y", rotation.y());
    xml.real("z", rotation.z());
    xml.close();
    xml.structure("translation");
    xml.real("x", pose.translation().x());
    xml.real("y", pose.translation().y());
    xml.real("z", pose.translation().z());
    xml.close();
    xml.close();
}

void writeLimits(XmlWriter& xml, const E57Part& part) {
    if (!part.bounds.empty()) {
        xml.structure("cartesianBounds");
        constexpr std::array kAxes{"x", "y", "z"};
        for (int axis = 0; axis < 3; ++axis) {
            const std::string name = kAxes[static_cast<std::size_t>(axis)];
            xml.real(name + "Minimum", part.bounds.min[axis]);
            xml.real(name + "Maximum", part.bounds.max[axis]);
        }
        xml.close();
    }
    if (part.intensityLimits) {
        const auto [low, high] = *part.intensityLimits;
        xml.structure("intensityLimits");
        const std::string type = part.intensityIsInteger ? "type=\"Integer\"" : "type=\"Float\"";
        xml.leaf("intensityMinimum", type, exactText(low));
        xml.leaf("intensityMaximum", type, exactText(high));
        xml.close();
    }
    if (part.colorMaximum > 0) {
        xml.structure("colorLimits");
        for (const std::string channel : {"colorRed", "colorGreen", "colorBlue"}) {
            xml.integer(channel + "Minimum", 0);
            xml.integer(channel + "Maximum", part.colorMaximum);
        }
        xml.close();
    }
}

void writeScan(XmlWriter& xml, const E57Part& part, const E57Section& section, const std::string& guid) {
    xml.structure("vectorChild");
    xml.text("guid", part.info.guid.empty() ? guid : part.info.guid);
    xml.text("name", part.info.name);
    xml.text("sensorVendor", part.info.sensorVendor);
    xml.text("sensorModel", part.info.sensorModel);
    xml.text("sensorSerialNumber", part.info.sensorSerial);
    if (part.timeStart) writeTime(xml, "acquisitionStart", *part.timeStart);
    writePose(xml, part.info.fileFromScan);
    writeLimits(xml, part);
    xml.open("points", "type=\"CompressedVector\" fileOffset=\"" +
                           std::to_string(E57PageWriter::physical(section.begin())) + "\" recordCount=\"" +
                           std::to_string(part.points) + "\"");
    xml.structure("prototype");
    for (const E57Column& column : part.columns) xml.leaf(column.element, column.attributes, column.value);
    xml.close();
    xml.vector("codecs");
    xml.close();
    xml.close();
    xml.close();
}

}  // namespace

bool isWkt(const std::string& crs) {
    return crs.find('[') != std::string::npos;
}

std::string e57Xml(const std::vector<E57Part>& parts, const std::vector<E57Section>& sections,
                   const FileInfo* source, const std::string& seed) {
    XmlWriter xml;
    xml.line("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
    xml.open("e57Root",
             "type=\"Structure\" xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\" "
             "xmlns:nor=\"http://www.libe57.org/E57_NOR_surface_normals.txt\" "
             "xmlns:las=\"http://www.astm.org/COMMIT/E57/2010-las-v1.0\"");
    xml.text("formatName", "ASTM E57 3D Imaging Data File");
    xml.text("guid", guidOf(seed));
    xml.integer("versionMajor", 1);
    xml.integer("versionMinor", 0);
    xml.text("e57LibraryVersion", std::string("Vestige ") + kVersion);
    if (source && isWkt(source->crs)) xml.text("coordinateMetadata", source->crs);
    if (source && source->creationDayYear && source->creationDayYear->second >= 1980)
        writeTime(xml, "creationDateTime",
                  gpsOfDayYear(source->creationDayYear->first, source->creationDayYear->second));
    xml.vector("data3D");
    for (std::size_t i = 0; i < parts.size(); ++i)
        writeScan(xml, parts[i], sections[i], guidOf(seed + "/" + std::to_string(i + 1)));
    xml.close();
    xml.vector("images2D");
    xml.close();
    xml.close();
    return xml.take();
}

}  // namespace vestige
