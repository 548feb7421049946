#include "lambert/image/composite/plan.h"

#include "lambert/base/error.h"
#include "lambert/base/json_events.h"
#include "lambert/image/composite/adjust.h"
#include "lambert/image/composite/key.h"
#include "lambert/image/composite/pointwise.h"

#include <cmath>
#include <utility>

namespace lambert::composite {
namespace {

class Planner {
 public:
  Planner(const FileAtFrame& file, Pictures& pictures, std::string_view text, const std::string& name)
      : file_(file), pictures_(pictures), text_(text), name_(name) {}

  ElementPtr element(const Expression& e, double frame, const Wanted& wanted) const {
    if (!e.word) return picture(pictures_, file_(e.text, frame), wanted);
    switch (e.word->form) {
      case Form::infix: return infix(e, frame, wanted);
      case Form::postfix: return postfix(e, frame, wanted);
      case Form::generator: return generator(e, frame);
    }
    return nullptr;
  }

 private:
  [[noreturn]] void fail(const Expression& e, const std::string& message) const {
    throw Error(location_in(text_, name_, e.place), std::string(e.word->name) + ": " + message);
  }

  ElementPtr infix(const Expression& e, double frame, const Wanted& wanted) const {
    const Verb verb = e.word->verb;
    Wanted inner = wanted;
    if (verb == Verb::zover) inner.names.emplace_back("Z");
    ElementPtr a = element(e.inputs[0], frame, inner), b = element(e.inputs[1], frame, inner);
    if (verb <= Verb::plus) return combined(static_cast<Operator>(verb), std::move(a), std::move(b));
    if (verb != Verb::zover) return arithmetic(verb, std::move(a), std::move(b));
    if (!a->shape().channel("Z") && !b->shape().channel("Z")) fail(e, "neither of its elements has a channel Z");
    return depth_combined(std::move(a), std::move(b));
  }

  /// What an operator wants of its input besides what is wanted of itself.
  static Wanted wanted_of_input(const Expression& e, const Wanted& wanted) {
    switch (e.word->verb) {
      case Verb::matte:
      case Verb::invert:
      case Verb::luminance:
      case Verb::edge: return {};
      case Verb::channel: return {.names = {e.text}};
      case Verb::depth_matte: return {.names = {"Z"}};
      case Verb::layer: return {.all = true};
      default: return wanted;
    }
  }

  ElementPtr postfix(const Expression& e, double frame, const Wanted& wanted) const {
    const auto number = [&](std::size_t i) { return e.numbers[i].at(frame); };
    if (e.word->verb == Verb::frame) return element(e.inputs[0], number(0), wanted);
    ElementPtr a = element(e.inputs[0], frame, wanted_of_input(e, wanted));
    ElementPtr m = e.word->second ? element(e.inputs[1], frame, {}) : nullptr;
    try {
      switch (e.word->verb) {
        case Verb::mask: return combined(Operator::in, std::move(a), matte_of(std::move(m)));
        case Verb::stencil: return combined(Operator::out, std::move(a), matte_of(std::move(m)));
        case Verb::multiply:
        case Verb::screen: return arithmetic(e.word->verb, std::move(a), std::move(m));
        case Verb::blur: return neighbourhood(Neighbourhood::blur, number(0), std::move(a));
        case Verb::erode: return neighbourhood(Neighbourhood::erode, number(0), std::move(a));
        case Verb::dilate: return neighbourhood(Neighbourhood::dilate, number(0), std::move(a));
        case Verb::edge: return neighbourhood(Neighbourhood::edge, number(0), matte_of(std::move(a)));
        case Verb::translate: return translated(number(0), number(1), std::move(a));
        case Verb::crop: {
          const auto whole = [&](std::size_t i) { return static_cast<int>(std::round(number(i))); };
          return cropped({whole(0), whole(1), whole(2), whole(3)}, std::move(a));
        }
        case Verb::layer: return layer(e.text, std::move(a));
        default: break;
      }
      std::vector<float> numbers;
      for (const Number& n : e.numbers) numbers.push_back(static_cast<float>(n.at(frame)));
      return pointwise(e.word->verb, numbers, e.text, std::move(a), std::move(m));
    } catch (const Error& error) {
      fail(e, error.what());
    }
  }

  ElementPtr generator(const Expression& e, double frame) const {
    std::vector<float> n;
    for (const Number& number : e.numbers) n.push_back(static_cast<float>(number.at(frame)));
    switch (e.word->verb) {
      case Verb::colour: return constant({n[0], n[1], n[2], n[3]});
      case Verb::disk: return disk(n[0], n[1], n[2], n[3]);
      case Verb::rectangle:
        return polygon_matte({n[0], n[1], n[0] + n[2], n[1], n[0] + n[2], n[1] + n[3], n[0], n[1] + n[3]});
      case Verb::gradient: return gradient(n[0], n[1], n[2], n[3]);
      default: return polygon_matte(n);
    }
  }

  static ElementPtr disk(float x, float y, float radius, float softness) {
    const float reach = radius + 0.5f * softness + 1;
    const auto floor = [](float v) { return static_cast<int>(std::floor(v)); };
    const Window box{floor(x - reach), floor(y - reach), floor(2 * reach) + 2, floor(2 * reach) + 2};
    const float width = std::max(softness, 1e-3f);
    return generated({.data = intersection(box, box)}, [=](float px, float py) {
      return coverage((radius - std::hypot(px - x, py - y)) / width + 0.5f);
    });
  }

  static ElementPtr gradient(float x0, float y0, float x1, float y1) {
    const float dx = x1 - x0, dy = y1 - y0, squared = dx * dx + dy * dy;
    return generated(
        {}, [=](float x, float y) { return squared > 0 ? coverage(((x - x0) * dx + (y - y0) * dy) / squared) : 0.0f; });
  }

  const FileAtFrame& file_;
  Pictures& pictures_;
  std::string_view text_;
  const std::string& name_;
};

}  // namespace

ElementPtr plan(const Expression& expression, double frame, const FileAtFrame& file, const Wanted& wanted,
                Pictures& pictures, std::string_view text, const std::string& name) {
  return Planner(file, pictures, text, name).element(expression, frame, wanted);
}

}  // namespace lambert::composite
