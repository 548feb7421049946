#include "lambert/draw/picture.h"

#include "lambert/draw/label_room.h"
#include "lambert/draw/sheet.h"
#include "lambert/draw/stroke_font.h"

#include <algorithm>
#include <cmath>

namespace lambert::draw {

using namespace polygon;

namespace {

constexpr Colour black{36, 41, 47}, grey{110, 119, 129}, faint{234, 238, 242};
constexpr double label_size = 11;

Box2 data_box(const Picture& picture) {
  Box2 box;
  for (const Picture::Area& area : picture.areas) box.add(box_of(area.rings));
  for (const Picture::Line& line : picture.lines) box.add(box_of(line.points));
  for (const Picture::Point& point : picture.points) box.add(point.at);
  for (const Picture::Label& label : picture.labels) box.add(label.at);
  return box;
}

class Artist {
 public:
  Artist(const Picture& picture, const PictureOptions& options)
      : picture_(picture), sheet_(data_box(picture), options, picture.title.empty() ? 0.0 : 26.0) {
    drawing_.width = sheet_.width();
    drawing_.height = sheet_.height() + legend_height();
  }

  Drawing finish(bool grid) {
    if (grid) draw_grid();
    for (const Picture::Area& area : picture_.areas)
      drawing_.marks.emplace_back(Fill{sheet_.rings(area.rings), area.rule, area.fill});
    for (const Picture::Area& area : picture_.areas)
      for (const Ring& ring : area.rings)
        drawing_.marks.emplace_back(Stroke{sheet_.ring(ring), true, area.edge, area.edge_width});
    for (const Picture::Line& line : picture_.lines) draw_line(line);
    draw_points();
    draw_labels();
    if (!picture_.title.empty()) drawing_.marks.emplace_back(Words{{sheet_.margin, 22}, picture_.title, black, 14});
    draw_legend();
    return std::move(drawing_);
  }

 private:
  void draw_grid() {
    const auto line = [&](Vec2d a, Vec2d b) { drawing_.marks.emplace_back(Stroke{{a, b}, false, faint, 1}); };
    const double left = sheet_.area().min.x, right = sheet_.area().max.x, top = sheet_.area().min.y,
                 bottom = sheet_.area().max.y;
    for (const auto& [x, text] : sheet_.columns()) {
      line({x, top}, {x, bottom});
      drawing_.marks.emplace_back(Words{{x, bottom + 14}, text, grey, 9, Anchor::middle});
    }
    for (const auto& [y, text] : sheet_.rows()) {
      line({left, y}, {right, y});
      const double end = std::max(left - 5, 2 + text_width(text, 9));  // a long number may reach into the padding
      drawing_.marks.emplace_back(Words{{end, y + 3}, text, grey, 9, Anchor::end});
    }
  }

  void draw_line(const Picture::Line& line) {
    const Ring points = sheet_.ring(line.points);
    drawing_.marks.emplace_back(Stroke{points, line.closed, line.colour, line.width, line.dashed ? 4.0 : 0.0});
    if (!line.arrows) return;
    const std::size_t n = points.size(), edges = line.closed || n == 0 ? n : n - 1;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vec2d a = points[i], b = points[next_index(i, n)], edge = b - a;
      const double length = glm::length(edge);
      if (!(length > 24) || !std::isfinite(length)) continue;
      const Vec2d along = edge / length, left(-along.y, along.x), tip = a + edge * 0.5 + along * 4.0;
      drawing_.marks.emplace_back(Fill{
          {{tip, tip - along * 8.0 + left * 3.5, tip - along * 8.0 - left * 3.5}}, FillRule::non_zero, line.colour});
    }
  }

  void draw_points() {
    Room room(2);
    for (const Picture::Point& point : picture_.points) {
      const Vec2d at = sheet_.point(point.at);
      const double r = point.radius;
      if (point.shape == Picture::Shape::cross) {
        drawing_.marks.emplace_back(Stroke{{at - Vec2d(r, r), at + Vec2d(r, r)}, false, point.colour, 1.6});
        drawing_.marks.emplace_back(Stroke{{at - Vec2d(r, -r), at + Vec2d(r, -r)}, false, point.colour, 1.6});
      } else if (point.shape == Picture::Shape::circle) {
        Ring ring;
        for (int i = 0; i < 24; ++i)
          ring.push_back(at + r * Vec2d(std::cos(i * 0.2617993877991494), std::sin(i * 0.2617993877991494)));
        drawing_.marks.emplace_back(Stroke{ring, true, point.colour, 1.6});
      } else if (room.take(at - Vec2d(0.4 * r), at + Vec2d(0.4 * r))) {
        drawing_.marks.emplace_back(Disk{at, r, point.colour});
      }
    }
  }

  void draw_labels() {
    Room room(16);
    for (const Picture::Point& point : picture_.points) {
      const Vec2d at = sheet_.point(point.at), reach(std::min(point.radius, 3.0));
      room.take(at - reach, at + reach);
    }
    for (const Picture::Label& label : picture_.labels) {
      const Vec2d at = sheet_.point(label.at);
      const double half_width = 0.5 * text_width(label.text, label_size) + 1, half_height = 0.36 * label_size + 1;
      const double length = glm::length(label.away);
      const Vec2d away = length > 0 ? Vec2d(label.away.x, -label.away.y) / length : Vec2d(0);
      for (const double turn : {0.0, 0.7, -0.7, 1.4, -1.4, 2.2, -2.2, 3.1}) {
        const Vec2d turned(away.x * std::cos(turn) - away.y * std::sin(turn),
                           away.x * std::sin(turn) + away.y * std::cos(turn));
        // The box just clears a disk of 5 pixels about the point.
        const Vec2d centre = at + turned * 5.0 + Vec2d(turned.x * half_width, turned.y * half_height);
        if (!room.take(centre - Vec2d(half_width, half_height), centre + Vec2d(half_width, half_height))) {
          if (length > 0) continue;
          break;
        }
        drawing_.marks.emplace_back(
            Words{centre + Vec2d(0, 0.36 * label_size), label.text, label.colour, label_size, Anchor::middle, true});
        break;
      }
    }
  }

  double legend_height() const {
    return 18.0 * static_cast<double>(picture_.legend.size()) + (picture_.legend.empty() ? 0 : 8);
  }
  void draw_legend() {
    double y = sheet_.height() + 8;
    for (const Picture::Entry& entry : picture_.legend) {
      const double x = sheet_.margin;
      drawing_.marks.emplace_back(
          Fill{{{{x, y - 9}, {x + 12, y - 9}, {x + 12, y + 1}, {x, y + 1}}}, FillRule::non_zero, entry.colour});
      drawing_.marks.emplace_back(Words{{x + 18, y}, entry.text, black, 11});
      y += 18;
    }
  }

  const Picture& picture_;
  Sheet sheet_;
  Drawing drawing_;
};

/// Away from both neighbours of a corner: into the larger of its two angles.
Vec2d away_from_edges(const Ring& ring, std::size_t i) {
  const auto unit = [](Vec2d v) {
    const double size = std::max(std::abs(v.x), std::abs(v.y));
    return size > 0 && std::isfinite(size) ? glm::normalize(v / size) : Vec2d(0);
  };
  const Vec2d to_next = unit(ring[next_index(i, ring.size())] - ring[i]);
  const Vec2d to_previous = unit(ring[previous_index(i, ring.size())] - ring[i]);
  const Vec2d away = -(to_next + to_previous);
  if (glm::dot(away, away) > 1e-6) return away;
  const Vec2d side(to_next.y, -to_next.x);
  return glm::dot(side, side) > 0 ? side : Vec2d(0, 1);
}

}  // namespace

void add_indices(Picture& picture, const Rings& rings, const Colour& colour, std::size_t first) {
  for (const Ring& ring : rings) {
    const double radius = ring.size() > 500 ? 1.2 : 2.6;  // the dots of many vertices would hide the edges
    for (std::size_t i = 0; i < ring.size(); ++i) {
      picture.points.push_back({.at = ring[i], .colour = colour, .radius = radius});
      picture.labels.push_back(
          {.at = ring[i], .text = std::to_string(first + i), .colour = colour, .away = away_from_edges(ring, i)});
    }
  }
}

Drawing drawn(const Picture& picture, const PictureOptions& options) {
  return Artist(picture, options).finish(options.grid);
}

}  // namespace lambert::draw
