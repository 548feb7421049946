#include "lambert/formats/gltf/animation.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/formats/gltf/hierarchy.h"

#include <algorithm>
#include <span>

namespace lambert::gltf {
namespace {

/// Between which keys a moment lies.
struct Moment {
  std::size_t key = 0, next = 0;
  float fraction = 0;  ///< of the way from one to the other
  float interval = 0;  ///< seconds between them
};

Moment moment_of(const std::vector<float>& times, float time, const JsonView& place) {
  if (times.empty()) place.fail("an animation needs at least one key");
  if (!std::is_sorted(times.begin(), times.end())) place.fail("the times of an animation must increase");
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return {};
  const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
  if (after == times.end()) return {key, key, 0, 0};
  const float interval = *after - times[key];
  return {key, key + 1, interval > 0 ? (time - times[key]) / interval : 0, interval};
}

enum class Interpolation { step, linear, cubic_spline };

Interpolation interpolation_of(const JsonView& json) {
  const std::string name = json.text("LINEAR");
  if (name == "STEP") return Interpolation::step;
  if (name == "LINEAR") return Interpolation::linear;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  json.fail("unknown interpolation " + unknown_word(name, {"STEP", "LINEAR", "CUBICSPLINE"}));
}

/// A channel's values about a moment; cubic splines also have tangents.
struct Keys {
  Moment moment;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> value, next;
  std::vector<float> out_tangent, in_tangent;  ///< of this key and of the next
};

/// A key's values are `width` elements of the accessor; a cubic spline's in-tangents stand before and its out-tangents
/// behind them.
class KeyReader {
 public:
  KeyReader(const Accessor& accessor, std::size_t key_count, bool cubic) : accessor_(accessor), parts_(cubic ? 3 : 1) {
    width_ = accessor.count() / (key_count * parts_);
    if (width_ * key_count * parts_ != accessor.count() || width_ == 0)
      accessor.fail("has " + std::to_string(accessor.count()) + " elements for " + std::to_string(key_count) + " keys");
  }
  std::vector<float> in_tangent(std::size_t key) const { return part(key, 0); }
  std::vector<float> value(std::size_t key) const { return part(key, parts_ / 2); }
  std::vector<float> out_tangent(std::size_t key) const { return part(key, 2); }

 private:
  std::vector<float> part(std::size_t key, std::size_t which) const {
    Selection elements(width_);
    for (std::size_t i = 0; i < width_; ++i)
      elements[i] = static_cast<std::uint32_t>((key * parts_ + which) * width_ + i);
    return accessor_.floats(elements);
  }
  const Accessor& accessor_;
  std::size_t parts_, width_;
};

Keys read_keys(Document& document, const JsonView& sampler, float time) {
  Keys keys;
  keys.interpolation = interpolation_of(sampler["interpolation"]);
  const bool cubic = keys.interpolation == Interpolation::cubic_spline;
  const Accessor input = document.accessor(sampler["input"]);
  if (input.components() != 1) input.fail("expected SCALAR times");
  const std::vector<float> times = input.floats();
  keys.moment = moment_of(times, time, sampler["input"]);
  const Accessor output = document.accessor(sampler["output"]);
  const KeyReader reader(output, times.size(), cubic);
  keys.value = reader.value(keys.moment.key);
  keys.next = reader.value(keys.moment.next);
  if (cubic) {
    keys.out_tangent = reader.out_tangent(keys.moment.key);
    keys.in_tangent = reader.in_tangent(keys.moment.next);
  }
  return keys;
}

/// Each number on its own (glTF 2.0, appendix C).
std::vector<float> interpolated(const Keys& keys) {
  if (keys.interpolation == Interpolation::step) return keys.value;
  const float t = keys.moment.fraction, t2 = t * t, t3 = t2 * t, d = keys.moment.interval;
  std::vector<float> result(keys.value.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (keys.interpolation == Interpolation::linear) {
      result[i] = (1 - t) * keys.value[i] + t * keys.next[i];
    } else {
      result[i] = (2 * t3 - 3 * t2 + 1) * keys.value[i] + d * (t3 - 2 * t2 + t) * keys.out_tangent[i] +
                  (3 * t2 - 2 * t3) * keys.next[i] + d * (t3 - t2) * keys.in_tangent[i];
    }
  }
  return result;
}

glm::quat interpolated_rotation(const Keys& keys) {
  const auto as_rotation = [](const std::vector<float>& v) { return rotation_of({v[0], v[1], v[2], v[3]}); };
  if (keys.interpolation != Interpolation::linear) return as_rotation(interpolated(keys));
  return glm::slerp(as_rotation(keys.value), as_rotation(keys.next), keys.moment.fraction);
}

/// `path` is what moves: "translation", "rotation", "scale" or "weights".
void apply(const Keys& keys, const std::string& path, NodePose& pose, const JsonView& place) {
  const std::size_t needed = path == "rotation" ? 4 : path == "translation" || path == "scale" ? 3 : 0;
  if (needed != 0 && keys.value.size() != needed)
    place.fail("a " + path + " needs " + std::to_string(needed) + " numbers, found " +
               std::to_string(keys.value.size()));
  if (path == "weights") {
    pose.weights = interpolated(keys);
    return;
  }
  pose.matrix.reset();
  if (path == "rotation") {
    pose.rotation = interpolated_rotation(keys);
  } else {
    const std::vector<float> v = interpolated(keys);
    (path == "scale" ? pose.scale : pose.translation) = {v[0], v[1], v[2]};
  }
}

}  // namespace

void apply_animation(Document& document, float time, std::vector<NodePose>& poses) {
  const JsonView animations = document.root()["animations"];
  if (animations.size() > 1)
    document.notes.add("only the first of " + std::to_string(animations.size()) + " glTF animations is played");
  const JsonView animation = animations[std::size_t{0}];
  for_each(animation["channels"], [&](const JsonView& channel) {
    const JsonView target = channel["target"];
    const std::string path = target["path"].text();
    const std::size_t sampler = channel["sampler"].count();
    if (sampler >= animation["samplers"].size()) channel["sampler"].fail("there is no such sampler");
    const bool moves_node = path == "translation" || path == "rotation" || path == "scale" || path == "weights";
    if (!target["node"] || !moves_node) {
      document.notes.add("glTF animation of '" + printable(path) + "' is ignored");
      return;
    }
    document.referred("nodes", target["node"]);
    apply(read_keys(document, animation["samplers"][sampler], time), path, poses[target["node"].count()], channel);
  });
}

}  // namespace lambert::gltf
