#include "lambert/formats/pbrt/directives.h"
#include "lambert/formats/pbrt/parser.h"

#include <array>

namespace lambert::pbrt {
namespace {

void include(Call& c) { c.parser.include(c.tokens.expect_string("the name of a file"), c.place()); }

// Unlike an included file, an imported one leaves no trace in the graphics state.
void import_file(Call& c) {
  const std::string file = c.tokens.expect_string("the name of a file");
  c.builder.begin_attributes();
  c.parser.include(file, c.place());
  c.builder.end_attributes(c.place());
}

void attribute(Call& c) {
  const std::string target = c.tokens.expect_string("the target of the attributes");
  c.builder.add_attributes(target, c.parameters(target));
}

void material(Call& c) {
  const std::string type = c.tokens.expect_string("the type of the material");
  c.builder.material(c.parameters(type), type);
}
void make_named_material(Call& c) {
  const std::string name = c.tokens.expect_string("the name of the material");
  c.builder.make_named_material(c.parameters(name), name);
}
void named_material(Call& c) {
  const std::string name = c.tokens.expect_string("the name of a material");
  c.builder.use_named_material(name, c.place());
}

void texture(Call& c) {
  const std::string name = c.tokens.expect_string("the name of the texture");
  const std::string type = c.tokens.expect_string("the type of the texture, \"float\" or \"spectrum\",");
  const std::string type_class = c.tokens.expect_string("the class of the texture");
  c.builder.texture(c.parameters(name), name, type, type_class);
}

void light_source(Call& c) {
  const std::string type = c.tokens.expect_string("the type of the light");
  c.builder.light(c.parameters(type), type);
}
void area_light_source(Call& c) {
  const std::string type = c.tokens.expect_string("the type of the area light");
  c.builder.area_light(c.parameters(type), type);
}
void shape(Call& c) {
  const std::string type = c.tokens.expect_string("the type of the shape");
  c.builder.shape(c.parameters(type), type);
}

void object_begin(Call& c) { c.builder.begin_object(c.tokens.expect_string("the name of the object"), c.place()); }
void object_end(Call& c) { c.builder.end_object(c.place()); }
void object_instance(Call& c) { c.builder.instance(c.tokens.expect_string("the name of an object"), c.place()); }

void make_named_medium(Call& c) {
  c.parameters(c.tokens.expect_string("the name of the medium"));
  c.builder.context().notes.add("participating media are ignored");
}
void medium_interface(Call& c) {
  const std::string inside = c.tokens.expect_string("the name of the medium inside");
  const std::string outside =
      c.tokens.peek().kind == TokenKind::string ? c.tokens.expect_string("the name of the medium outside") : inside;
  if (!inside.empty() || !outside.empty()) c.builder.context().notes.add("participating media are ignored");
}

void attribute_begin(Call& c) { c.builder.begin_attributes(); }
void attribute_end(Call& c) { c.builder.end_attributes(c.place()); }
void reverse_orientation(Call& c) { c.builder.reverse_orientation(); }
void colour_space(Call& c) {
  c.builder.set_colour_space(c.tokens.expect_string("the name of a colour space"), c.place());
}

constexpr std::array<Directive, 19> directives{{
    {"AreaLightSource", Where::in_world, area_light_source},
    {"Attribute", Where::anywhere, attribute},
    {"AttributeBegin", Where::in_world, attribute_begin},
    {"AttributeEnd", Where::in_world, attribute_end},
    {"ColorSpace", Where::anywhere, colour_space},
    {"Import", Where::in_world, import_file},
    {"Include", Where::anywhere, include},
    {"LightSource", Where::in_world, light_source},
    {"MakeNamedMaterial", Where::in_world, make_named_material},
    {"MakeNamedMedium", Where::anywhere, make_named_medium},
    {"Material", Where::in_world, material},
    {"MediumInterface", Where::anywhere, medium_interface},
    {"NamedMaterial", Where::in_world, named_material},
    {"ObjectBegin", Where::in_world, object_begin},
    {"ObjectEnd", Where::in_world, object_end},
    {"ObjectInstance", Where::in_world, object_instance},
    {"ReverseOrientation", Where::in_world, reverse_orientation},
    {"Shape", Where::in_world, shape},
    {"Texture", Where::in_world, texture},
}};

}  // namespace

std::span<const Directive> world_directives() { return directives; }

}  // namespace lambert::pbrt
