#include "lambert/formats/pbrt/spectra.h"

#include "lambert/base/number.h"
#include "lambert/formats/input_file.h"
#include "lambert/formats/pbrt/illuminants.h"

#include <algorithm>
#include <cmath>

namespace lambert::pbrt {
namespace {

constexpr std::string_view metal_prefix = "metal-", glass_prefix = "glass-";

std::vector<std::string> spectrum_names() {
  std::vector<std::string> names = illuminant_names();
  for (const std::string& n : metal_names())
    names.push_back("metal-" + n + "-eta"), names.push_back("metal-" + n + "-k");
  for (const std::string& n : glass_names()) names.push_back("glass-" + n);
  return names;
}

std::optional<Rgb> metal_spectrum(std::string_view name) {
  if (!name.starts_with(metal_prefix)) return std::nullopt;
  name.remove_prefix(metal_prefix.size());
  for (const bool is_eta : {true, false}) {
    const std::string_view suffix = is_eta ? "-eta" : "-k";
    if (!name.ends_with(suffix)) continue;
    const auto metal = named_metal(name.substr(0, name.size() - suffix.size()));
    if (metal) return is_eta ? metal->eta : metal->k;
  }
  return std::nullopt;
}

std::optional<GlassData> glass_spectrum(std::string_view name) {
  if (!name.starts_with(glass_prefix)) return std::nullopt;
  return named_glass(name.substr(glass_prefix.size()));
}

Rgb with_luminance_one(Rgb c) {
  // Colours outside of Rec. 709 lose what they lack.
  c = max(c, Rgb());
  const float y = luminance(c);
  return y > 0 ? c / y : Rgb();
}

SpectrumSamples checked(const Parameter& p, SpectrumSamples samples) {
  const bool ordered =
      std::is_sorted(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  if (samples.empty() || !ordered) p.fail("the wavelengths of spectrum '" + p.name + "' must be in rising order");
  return samples;
}

SpectrumSamples samples_of(const Context& context, const Parameter& p) {
  if (p.strings.empty()) {
    if (p.floats.size() % 2 != 0) p.fail("spectrum '" + p.name + "' takes pairs of wavelength and value");
    SpectrumSamples samples;
    for (std::size_t i = 0; i < p.floats.size(); i += 2) samples.emplace_back(p.floats[i], p.floats[i + 1]);
    return checked(p, std::move(samples));
  }
  const std::string& name = p.strings[0];
  if (!name.ends_with(".spd")) p.fail("unknown spectrum " + unknown_word(name, spectrum_names()));
  return checked(p, read_spd(context.resolve(name)));
}

Rgb spectrum_rgb(const Context& context, const Parameter& p, SpectrumRole role) {
  if (p.strings.size() == 1) {
    if (const auto metal = metal_spectrum(p.strings[0])) return *metal;
    if (const auto glass = glass_spectrum(p.strings[0])) return Rgb(glass->eta);
    if (const auto illuminant = named_illuminant(p.strings[0])) return with_luminance_one(*illuminant);
  }
  const SpectrumSamples samples = samples_of(context, p);
  return role == SpectrumRole::illuminant ? with_luminance_one(spectrum_to_emission_rgb(samples))
                                          : spectrum_to_reflectance_rgb(samples);
}

Rgb blackbody_rgb(const Parameter& p, SpectrumRole role) {
  if (p.floats.size() != 1) p.fail("blackbody '" + p.name + "' takes one temperature");
  if (!(p.floats[0] > 0)) p.fail("blackbody '" + p.name + "' takes a temperature above 0 kelvin");
  const SpectrumSamples samples = blackbody(p.floats[0]);
  return role == SpectrumRole::illuminant ? with_luminance_one(spectrum_to_emission_rgb(samples))
                                          : spectrum_to_reflectance_rgb(samples);
}

// Linear between samples, constant outside.
float value_at(const SpectrumSamples& s, float wavelength) {
  if (wavelength <= s.front().first) return s.front().second;
  for (std::size_t i = 1; i < s.size(); ++i) {
    const auto [l0, v0] = s[i - 1];
    const auto [l1, v1] = s[i];
    if (wavelength <= l1) return l1 > l0 ? v0 + (v1 - v0) * (wavelength - l0) / (l1 - l0) : v1;
  }
  return s.back().second;
}

GlassData glass_from_samples(const SpectrumSamples& s) {
  // V_d = (n_d - 1) / (n_F - n_C) at Fraunhofer's lines d, F and C.
  const float n_d = value_at(s, 587.6f), n_f = value_at(s, 486.1f), n_c = value_at(s, 656.3f);
  return {n_d, n_f - n_c > 1e-6f ? (n_d - 1) / (n_f - n_c) : 0.0f};
}

}  // namespace

Rgb rgb_value(const Context& context, const Parameter& p, SpectrumRole role) {
  Rgb c;
  if (p.type == ParameterType::blackbody) {
    c = blackbody_rgb(p, role);
  } else if (p.type == ParameterType::spectrum) {
    if (p.strings.size() > 1) p.fail("spectrum '" + p.name + "' takes one name");
    c = spectrum_rgb(context, p, role);
  } else {
    if (p.floats.size() != 3) p.fail("rgb '" + p.name + "' takes 3 numbers");
    c = p.colour_space.to_rec709({p.floats[0], p.floats[1], p.floats[2]});
  }
  if (role != SpectrumRole::reflectance || c == clamp(c, 0, 1)) return c;
  context.notes.add(SourceLocation(p.place).to_string() + ": '" + p.name + "' is clamped to [0, 1]");
  return clamp(c, 0, 1);
}

Rgb rgb_value(const Context& context, const ParameterList& list, std::string_view name, Rgb fallback,
              SpectrumRole role) {
  const Parameter* p = list.find(name, {ParameterType::rgb, ParameterType::spectrum, ParameterType::blackbody});
  return p ? rgb_value(context, *p, role) : fallback;
}

GlassData index_of_refraction(const Context& context, const ParameterList& list, std::string_view name) {
  const Parameter* p = list.find(name, {ParameterType::floating, ParameterType::spectrum});
  if (!p) return {};
  GlassData glass;
  if (p->type == ParameterType::floating) {
    glass.eta = list.number(name, 1.5f);
  } else if (const auto named = p->strings.size() == 1 ? glass_spectrum(p->strings[0]) : std::nullopt) {
    glass = *named;
  } else {
    glass = glass_from_samples(samples_of(context, *p));
  }
  if (!(glass.eta > 0)) p->fail("the index of refraction must be above 0");
  return glass;
}

SpectrumSamples read_spd(const std::filesystem::path& path) {
  const InputFile file(path);
  Tokenizer tokens(file.text(), path.string());
  SpectrumSamples samples;
  while (tokens.peek().kind != TokenKind::end) {
    const float wavelength = tokens.expect_number("a wavelength in nanometres");
    samples.emplace_back(wavelength, tokens.expect_number("the value at that wavelength"));
  }
  return samples;
}

}  // namespace lambert::pbrt
