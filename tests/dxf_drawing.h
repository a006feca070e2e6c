#pragma once

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ravnoves::test {

/// What dxflib reads back, by layers.
class DxfDrawing : public DL_CreationAdapter {
  public:
    struct Polyline {
        bool closed = false;
        std::vector<DL_VertexData> points;
    };

    explicit DxfDrawing(const std::string& text) {
        std::stringstream stream(text);
        EXPECT_TRUE(DL_Dxf().in(stream, this));
    }

    std::set<std::string> layers;
    std::multimap<std::string, DL_ArcData> arcs;
    std::multimap<std::string, DL_LineData> lines;
    std::map<std::string, Polyline> polylines;  ///< one of each layer
    std::vector<DL_TextData> texts;
    int units = -1;

    void addLayer(const DL_LayerData& layer) override { layers.insert(layer.name); }
    void addArc(const DL_ArcData& arc) override { arcs.emplace(attributes.getLayer(), arc); }
    void addLine(const DL_LineData& line) override { lines.emplace(attributes.getLayer(), line); }
    void addPolyline(const DL_PolylineData& line) override {
        current_ = &polylines[attributes.getLayer()];
        current_->closed = (line.flags & 1) != 0;
    }
    void addVertex(const DL_VertexData& vertex) override {
        current_->points.push_back(vertex);
        EXPECT_EQ(vertex.bulge, 0.0);
    }
    void addText(const DL_TextData& text) override { texts.push_back(text); }
    void setVariableInt(const std::string& key, int value, int) override {
        units = key == "$INSUNITS" ? value : units;
    }

  private:
    Polyline* current_ = nullptr;
};

}  // namespace ravnoves::test
