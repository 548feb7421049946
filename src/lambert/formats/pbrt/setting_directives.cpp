#include "lambert/formats/pbrt/directives.h"
#include "lambert/formats/pbrt/film.h"

#include <array>

namespace lambert::pbrt {
namespace {

using ReadSetting = void (*)(Context&, const ParameterList&, const std::string&);

void read_setting(Call& c, ReadSetting read) {
  const std::string type = c.tokens.expect_string("a type");
  const ParameterList list = c.parameters(type);
  read(c.builder.context(), list, type);
  list.note_unused(c.builder.context().notes);
}

void film(Call& c) {
  const std::string type = c.tokens.expect_string("the type of the film");
  const ParameterList list = c.parameters(type);
  c.builder.film(list, type);
  list.note_unused(c.builder.context().notes);
}

void camera(Call& c) {
  const std::string type = c.tokens.expect_string("the type of the camera");
  c.builder.camera(c.parameters(type), type);
}

void option(Call& c) {
  const std::string name = c.tokens.expect_string("the name of the option");
  const Token value = c.tokens.next();
  if (value.kind != TokenKind::word && value.kind != TokenKind::number && value.kind != TokenKind::string) {
    c.tokens.fail(value, "expected the value of option '" + name + "', found " + describe(value));
  }
  c.builder.context().notes.add("option '" + name + "' is ignored");
}

void accelerator(Call& c) { c.parameters(c.tokens.expect_string("the type of the accelerator")); }
void integrator(Call& c) { read_setting(c, read_integrator); }
void pixel_filter(Call& c) { read_setting(c, read_filter); }
void sampler(Call& c) { read_setting(c, read_sampler); }
void world_begin(Call& c) { c.builder.world_begin(c.place()); }

constexpr std::array<Directive, 8> directives{{
    {"Accelerator", Where::before_world, accelerator},
    {"Camera", Where::before_world, camera},
    {"Film", Where::before_world, film},
    {"Integrator", Where::before_world, integrator},
    {"Option", Where::before_world, option},
    {"PixelFilter", Where::before_world, pixel_filter},
    {"Sampler", Where::before_world, sampler},
    {"WorldBegin", Where::before_world, world_begin},
}};

}  // namespace

std::span<const Directive> setting_directives() { return directives; }

}  // namespace lambert::pbrt
