#include "drawing/dxf_document.h"

#include <dxflib/dl_dxf.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

#include "case-file/text_file.h"

namespace ravnoves {

namespace {

/// A file that is gone when the object is.
class TemporaryFile {
  public:
    TemporaryFile() {
        path_ = (std::filesystem::temp_directory_path() / "ravnoves-XXXXXX").string();
        const int handle = ::mkstemp(path_.data());
        if (handle < 0) {
            throw std::runtime_error("no temporary file can be made in " +
                                     std::filesystem::temp_directory_path().string());
        }
        ::close(handle);
    }
    ~TemporaryFile() { std::remove(path_.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

std::string ascii(const std::string& text) {
    std::string kept;
    for (const char c : text) {
        if (c >= ' ' && c <= '~') {
            kept += c;
        }
    }
    return kept;
}

DL_Attributes on_layer(const std::string& layer) {
    constexpr int by_layer = 256;
    return {layer, by_layer, 0, -1, "BYLAYER"};
}

void write_head(DL_Dxf& dxf, DL_WriterA& out, const std::vector<DxfDocument::Layer>& layers) {
    dxf.writeHeader(out);
    constexpr int millimetres = 4;
    out.dxfString(9, "$INSUNITS");
    out.dxfInt(70, millimetres);
    out.dxfString(9, "$MEASUREMENT");
    out.dxfInt(70, 1);
    out.sectionEnd();

    out.sectionTables();
    dxf.writeVPort(out);
    out.tableLinetypes(3);
    dxf.writeLinetype(out, DL_LinetypeData("BYBLOCK", "BYBLOCK", 0, 0, 0.0));
    dxf.writeLinetype(out, DL_LinetypeData("BYLAYER", "BYLAYER", 0, 0, 0.0));
    dxf.writeLinetype(out, DL_LinetypeData("CONTINUOUS", "Continuous", 0, 0, 0.0));
    out.tableEnd();
    out.tableLayers(static_cast<int>(layers.size()) + 1);
    constexpr int line_width = 25;  // hundredths of a millimetre
    dxf.writeLayer(out, DL_LayerData("0", 0),
                   DL_Attributes("", DxfDocument::white, 0, line_width, "CONTINUOUS"));
    for (const DxfDocument::Layer& layer : layers) {
        dxf.writeLayer(out, DL_LayerData(layer.name, 0),
                       DL_Attributes("", layer.colour, 0, line_width, "CONTINUOUS"));
    }
    out.tableEnd();
    out.tableStyle(1);
    dxf.writeStyle(out, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
    out.tableEnd();
    dxf.writeView(out);
    dxf.writeUcs(out);
    out.tableAppid(1);
    dxf.writeAppid(out, "ACAD");
    out.tableEnd();
    dxf.writeDimStyle(out, 2.5, 0.625, 0.625, 0.625, 2.5);
    dxf.writeBlockRecord(out);
    out.tableEnd();
    out.sectionEnd();

    out.sectionBlocks();
    for (const char* block : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
        dxf.writeBlock(out, DL_BlockData(block, 0, 0.0, 0.0, 0.0));
        dxf.writeEndBlock(out, block);
    }
    out.sectionEnd();
}

}  // namespace

void DxfDocument::line(Point from, Point to, const std::string& layer) {
    entities_.emplace_back([=](DL_Dxf& dxf, DL_WriterA& out) {
        dxf.writeLine(out, DL_LineData(from.x, from.y, 0.0, to.x, to.y, 0.0), on_layer(layer));
    });
}

void DxfDocument::polyline(std::vector<Point> points, bool closed, const std::string& layer) {
    entities_.emplace_back([=, points = std::move(points)](DL_Dxf& dxf, DL_WriterA& out) {
        const auto count = static_cast<int>(points.size());
        dxf.writePolyline(out, DL_PolylineData(count, 0, 0, closed ? 1 : 0), on_layer(layer));
        for (const Point& point : points) {
            dxf.writeVertex(out, DL_VertexData(point.x, point.y, 0.0, 0.0));
        }
        dxf.writePolylineEnd(out);
    });
}

void DxfDocument::arc(Point centre, double radius, double from_deg, double to_deg,
                      const std::string& layer) {
    entities_.emplace_back([=](DL_Dxf& dxf, DL_WriterA& out) {
        dxf.writeArc(out, DL_ArcData(centre.x, centre.y, 0.0, radius, from_deg, to_deg),
                     on_layer(layer));
    });
}

void DxfDocument::text(Point place, double height, const std::string& words,
                       const std::string& layer) {
    entities_.emplace_back([=, kept = ascii(words)](DL_Dxf& dxf, DL_WriterA& out) {
        dxf.writeText(out,
                      DL_TextData(place.x, place.y, 0.0, place.x, place.y, 0.0, height, 1.0, 0, 0,
                                  0, kept, "Standard", 0.0),
                      on_layer(layer));
    });
}

std::string DxfDocument::write() const {
    const TemporaryFile file;
    {
        DL_Dxf dxf;
        const std::unique_ptr<DL_WriterA> writer(dxf.out(file.path().c_str(), DL_VERSION_2000));
        if (!writer) {
            throw std::runtime_error("the temporary file " + file.path() + " cannot be written");
        }
        DL_WriterA& out = *writer;
        write_head(dxf, out, layers_);
        out.sectionEntities();
        for (const auto& write_entity : entities_) {
            write_entity(dxf, out);
        }
        out.sectionEnd();
        dxf.writeObjects(out);
        dxf.writeObjectsEnd(out);
        out.dxfEOF();
        out.close();
    }
    return read_text_file(file.path());
}

}  // namespace ravnoves
