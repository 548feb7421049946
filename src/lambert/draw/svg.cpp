#include "lambert/draw/svg.h"

#include "lambert/base/number.h"

#include <algorithm>
#include <cmath>

namespace lambert::draw {
namespace {

bool is_finite(const Ring& points) {
  return std::all_of(points.begin(), points.end(), [](Vec2d p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

class Writer {
 public:
  explicit Writer(const Drawing& drawing) {
    const std::string width = number(drawing.width), height = number(drawing.height);
    text_ = R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" + width + R"(" height=")" + height +
            R"(" viewBox="0 0 )" + width + " " + height +
            "\" font-family=\"Helvetica,Arial,sans-serif\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n" +
            "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  }

  std::string take() { return std::move(text_) + "</svg>\n"; }

  void operator()(const Fill& fill) {
    std::string path;
    for (const Ring& ring : fill.rings)
      if (ring.size() > 1 && is_finite(ring)) append_path(path, ring, true);
    if (path.empty()) return;
    text_ += "<path d=\"" + path + "\"" + paint("fill", fill.colour);
    if (fill.rule == FillRule::even_odd) text_ += " fill-rule=\"evenodd\"";
    text_ += "/>\n";
  }

  void operator()(const Stroke& stroke) {
    if (stroke.points.size() < 2 || !is_finite(stroke.points)) return;
    std::string path;
    append_path(path, stroke.points, stroke.closed);
    text_ += "<path d=\"" + path + "\" fill=\"none\"" + paint("stroke", stroke.colour) + " stroke-width=\"" +
             number(stroke.width) + "\"";
    if (stroke.dash > 0) text_ += " stroke-dasharray=\"" + number(stroke.dash) + "\"";
    text_ += "/>\n";
  }

  void operator()(const Disk& disk) {
    if (!is_finite({disk.centre})) return;
    text_ += "<circle cx=\"" + number(disk.centre.x) + "\" cy=\"" + number(disk.centre.y) + "\" r=\"" +
             number(disk.radius) + "\"" + paint("fill", disk.colour) + "/>\n";
  }

  void operator()(const Words& words) {
    static constexpr const char* anchors[] = {"start", "middle", "end"};
    if (!is_finite({words.at})) return;
    text_ += "<text x=\"" + number(words.at.x) + "\" y=\"" + number(words.at.y) + "\" font-size=\"" +
             number(words.size) + "\"" + paint("fill", words.colour);
    if (words.anchor != Anchor::start)
      text_ += std::string(" text-anchor=\"") + anchors[static_cast<int>(words.anchor)] + "\"";
    if (words.halo) text_ += " paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\"";
    text_ += ">" + escaped(words.text) + "</text>\n";
  }

 private:
  static std::string number(double value) {
    return number_text(std::round(std::clamp(value, -1e9, 1e9) * 100) / 100 + 0.0);
  }
  static void append_path(std::string& path, const Ring& points, bool closed) {
    char command = 'M';
    for (const Vec2d p : points) {
      path += command + number(p.x) + " " + number(p.y);
      command = 'L';
    }
    if (closed) path += "Z";
  }
  static std::string paint(const std::string& what, const Colour& colour) {
    const std::string plain = " " + what + "=\"" + hex(colour) + "\"";
    return colour.opacity < 1 ? plain + " " + what + "-opacity=\"" + number(colour.opacity) + "\"" : plain;
  }
  static std::string escaped(const std::string& words) {
    std::string safe;
    for (const char c : words) {
      if (c == '<') {
        safe += "&lt;";
      } else if (c == '&') {
        safe += "&amp;";
      } else {
        safe += c >= ' ' && c <= '~' ? c : '?';
      }
    }
    return safe;
  }

  std::string text_;
};

}  // namespace

std::string svg_text(const Drawing& drawing) {
  Writer writer(drawing);
  for (const auto& mark : drawing.marks) std::visit([&](const auto& m) { writer(m); }, mark);
  return writer.take();
}

}  // namespace lambert::draw
