#pragma once

#include <functional>
#include <string>
#include <vector>

class DL_Dxf;
class DL_WriterA;

namespace ravnoves {

/// A flat drawing for the machine shop, collected in mm and written as DXF (AutoCAD 2000).
///
/// The text has a decimal point in any locale; notes keep only their ASCII characters, since the
/// format's code page is not ours to choose.
class DxfDocument {
  public:
    struct Layer {
        std::string name;
        int colour;  ///< AutoCAD colour index
    };
    static constexpr int white = 7;
    static constexpr int red = 1;
    static constexpr int cyan = 4;
    static constexpr int grey = 8;

    struct Point {
        double x = 0.0;  ///< mm
        double y = 0.0;  ///< mm
    };

    explicit DxfDocument(std::vector<Layer> layers) : layers_(std::move(layers)) {}

    void line(Point from, Point to, const std::string& layer);
    void polyline(std::vector<Point> points, bool closed, const std::string& layer);
    /// Counter-clockwise from one angle to the other, ° from +x.
    void arc(Point centre, double radius, double from_deg, double to_deg, const std::string& layer);
    /// Lower left corner and height of the letters, mm.
    void text(Point place, double height, const std::string& words, const std::string& layer);

    /// The whole file.
    /// @throws std::runtime_error where no temporary file can be made
    std::string write() const;

  private:
    std::vector<Layer> layers_;
    std::vector<std::function<void(DL_Dxf& dxf, DL_WriterA& out)>> entities_;
};

}  // namespace ravnoves
