#include "lambert/bsdf/gltf_pbr.h"

#include "lambert/bsdf/albedo_tables.h"
#include "lambert/bsdf/fresnel.h"
#include "lambert/bsdf/microfacet.h"
#include "lambert/bsdf/sheen.h"
#include "lambert/sampling/warp.h"

#include "lambert/bsdf/iridescence.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert {
namespace {

enum Lobe : std::size_t { specular_lobe, diffuse_lobe, transmission_lobe, coat_lobe, sheen_lobe, lobe_count };
constexpr float coat_f0 = 0.04f;

Vec3 upward(Vec3 v) { return v.z < 0 ? -v : v; }
Vec3 mirrored(Vec3 v) { return {v.x, v.y, -v.z}; }

/// A material seen from one direction: what all of eval, pdf and sample need. Directions have wo.z > 0, so `eta` is the
/// index of the far side over the near one.
class View {
 public:
  View(const GltfPbr& m, Vec3 wo) : m_(m), ggx_(m.alpha_x, m.alpha_y), coat_ggx_(m.clearcoat_alpha, m.clearcoat_alpha) {
    inside_ = wo.z < 0 && !m.thin_walled;
    wo_ = wo.z < 0 ? mirrored(wo) : wo;
    eta_ = inside_ ? 1 / m.ior : m.ior;
    smooth_ = Ggx::effectively_smooth(m.alpha_x, m.alpha_y);
    coat_smooth_ = Ggx::effectively_smooth(m.clearcoat_alpha, m.clearcoat_alpha);
    through_smooth_ = smooth_ || (!m.thin_walled && m.ior == 1);  // no border: no facet bends light
    alpha_ = std::sqrt(m.alpha_x * m.alpha_y);
    f0_ = clamp(m.specular_colour * f0_of_eta(m.ior), 0, 1) * m.specular;
    const float body = (1 - m.metallic);
    // From inside a body total reflection leaves nothing to share with a diffuse lobe.
    if (!inside_) diffuse_ = m.base_colour * (body * (1 - m.transmission));
    through_ = m.base_colour * (body * m.transmission);
    prepare_diffuse_scale();
    choose_lobes();
  }

  bool smooth() const { return smooth_; }
  bool coat_smooth() const { return coat_smooth_; }
  bool through_smooth() const { return through_smooth_; }
  float share(Lobe lobe) const { return shares_[lobe]; }

  /// All lobes but Dirac ones; wi in wo's frame (z > 0: reflected).
  Rgb eval(Vec3 wi, Transport mode) const {
    const float above = over_base(wi);
    if (wi.z < 0) return transmission_value(wi, mode) * above;
    Rgb f = diffuse_ * (diffuse_scale(wi) * inv_pi * wi.z);
    if (!smooth_) {
      const Vec3 h = normalize(wo_ + wi);
      f += fresnel(dot(wo_, h)) * (ggx_.d(h) * ggx_.g2(wo_, wi) / (4 * wo_.z));
    }
    f *= above;
    if (m_.clearcoat > 0 && !coat_smooth_) f += Rgb(coat_value(wi) * over_coat(wi));
    if (has_sheen()) f += m_.sheen_colour * (sheen_value(wo_, wi, m_.sheen_roughness) * wi.z);
    return f;
  }

  float pdf(Vec3 wi) const {
    if (wi.z < 0) return shares_[transmission_lobe] * transmission_pdf(wi);
    float p = (shares_[diffuse_lobe] + shares_[sheen_lobe]) * cosine_hemisphere_pdf(wi);
    if (smooth_ && coat_smooth_) return p;
    const Vec3 h = normalize(wo_ + wi);
    const float to_reflection = 1 / (4 * dot(wo_, h));
    if (!smooth_) p += shares_[specular_lobe] * ggx_.visible_d(wo_, h) * to_reflection;
    if (!coat_smooth_) p += shares_[coat_lobe] * coat_ggx_.visible_d(wo_, h) * to_reflection;
    return p;
  }

  std::optional<Vec3> sample_direction(Lobe lobe, Vec2 u) const {
    if (lobe == diffuse_lobe || lobe == sheen_lobe) return square_to_cosine_hemisphere(u);
    const bool coat = lobe == coat_lobe, flat = coat                        ? coat_smooth_
                                                : lobe == transmission_lobe ? through_smooth_
                                                                            : smooth_;
    const Vec3 h = flat ? Vec3(0, 0, 1) : (coat ? coat_ggx_ : ggx_).sample_visible(wo_, u);
    if (lobe == transmission_lobe && !m_.thin_walled) {
      const auto wi = refract(wo_, h, eta_);
      return wi && wi->z < 0 ? wi : std::nullopt;
    }
    const Vec3 wi = reflect(wo_, h);
    if (wi.z <= 0) return std::nullopt;
    return lobe == transmission_lobe ? mirrored(wi) : wi;
  }

  /// f |cos| of the Dirac lobe, as a factor.
  Rgb dirac_weight(Lobe lobe, Vec3 wi, Transport mode) const {
    if (lobe == coat_lobe) return Rgb(m_.clearcoat * coat_fresnel(wo_.z) * over_coat(wi));
    if (lobe == specular_lobe) return fresnel(wo_.z) * over_base(wi);
    const float scale = !m_.thin_walled && mode == Transport::radiance ? 1 / (eta_ * eta_) : 1.0f;
    return through_ * (Rgb(1.0f) - dielectric_fresnel(wo_.z)) * (scale * over_base(wi));
  }

  float eta_through() const { return m_.thin_walled ? 1.0f : eta_; }

  Rgb albedo() const {
    const float above = over_base(wo_);
    const Rgb base = specular_albedo() + diffuse_ * (1 - dielectric_albedo_) + through_ * (1 - dielectric_albedo_);
    Rgb all = base * above + Rgb(m_.clearcoat * coat_fresnel(wo_.z) * over_coat(wo_));
    if (has_sheen()) all += m_.sheen_colour * sheen_albedo(wo_.z, m_.sheen_roughness);
    return all;
  }

 private:
  bool has_sheen() const { return max_component(m_.sheen_colour) > 0; }

  /// f0 to f90 along the exact curve, which also knows total reflection.
  Rgb dielectric_fresnel(float cos_i) const {
    const float normal = f0_of_eta(m_.ior), exact = fresnel_dielectric(cos_i, eta_);
    const float weight = normal < 1 ? std::max(0.0f, (exact - normal) / (1 - normal)) : 1;
    return lerp(f0_, Rgb(m_.specular), weight);
  }
  Rgb fresnel(float cos_i) const {
    Rgb f = dielectric_fresnel(cos_i);
    if (m_.metallic > 0) f = lerp(f, fresnel_schlick(cos_i, m_.base_colour, Rgb(1.0f)), m_.metallic);
    if (m_.iridescence > 0 && !inside_) {
      const Rgb base = lerp(f0_, m_.base_colour, m_.metallic);
      f = lerp(f, fresnel_iridescent(cos_i, m_.iridescence_ior, m_.iridescence_thickness_nm, base), m_.iridescence);
    }
    return f;
  }

  static float coat_fresnel(float cos_i) { return coat_f0 + (1 - coat_f0) * schlick_weight(cos_i); }
  float coat_value(Vec3 wi) const {
    const Vec3 h = normalize(wo_ + wi);
    return m_.clearcoat * coat_fresnel(dot(wo_, h)) * coat_ggx_.d(h) * coat_ggx_.g2(wo_, wi) / (4 * wo_.z);
  }

  /// What sheen leaves to the coat, and sheen and coat to the base.
  float over_coat(Vec3 wi) const {
    if (!has_sheen()) return 1;
    const float c = max_component(m_.sheen_colour);
    return std::max(0.0f, 1 - c * std::max(sheen_albedo(wo_.z, m_.sheen_roughness),
                                           sheen_albedo(std::abs(wi.z), m_.sheen_roughness)));
  }
  float over_base(Vec3 wi) const {
    float left = over_coat(wi);
    if (m_.clearcoat > 0)
      left *= (1 - m_.clearcoat * coat_fresnel(wo_.z)) * (1 - m_.clearcoat * coat_fresnel(std::abs(wi.z)));
    return left;
  }

  /// What the dielectric's specular lobe reflects: the table's, which follows Schlick's curve, raised to the exact one
  /// (that is up to a quarter above it) or to the film's. At most a percent of energy appears by the estimate.
  float dielectric_albedo(float cos) const {
    const float f0 = max_component(f0_), table = ggx_albedo(cos, alpha_)(f0, m_.specular);
    if (inside_) return table;
    const float schlick = f0 + (m_.specular - f0) * schlick_weight(cos);
    const float exact = max_component(dielectric_fresnel(cos));
    float albedo = schlick > 0 ? table * std::max(1.0f, exact / schlick) : table;
    if (m_.iridescence > 0) {
      const Rgb film = fresnel_iridescent(cos, m_.iridescence_ior, m_.iridescence_thickness_nm, f0_);
      albedo += m_.iridescence * std::max(0.0f, max_component(film) - albedo);
    }
    return std::min(albedo, 1.0f);
  }
  void prepare_diffuse_scale() {
    dielectric_albedo_ = dielectric_albedo(wo_.z);
    if (is_black(diffuse_)) return;
    mean_albedo_ = ggx_mean_albedo(alpha_)(max_component(f0_), m_.specular);
  }
  float diffuse_scale(Vec3 wi) const {
    if (is_black(diffuse_)) return 0;
    return (1 - dielectric_albedo_) * (1 - dielectric_albedo(wi.z)) / (1 - mean_albedo_);
  }
  Rgb specular_albedo() const {
    const GgxAlbedo a = ggx_albedo(wo_.z, alpha_);
    const Rgb dielectric = f0_ * a.scale + Rgb(m_.specular * a.bias), metal = m_.base_colour * a.scale + Rgb(a.bias);
    return lerp(dielectric, metal, m_.metallic);
  }

  Rgb transmission_value(Vec3 wi, Transport mode) const {
    if (through_smooth_ || is_black(through_)) return {};
    if (m_.thin_walled) {
      const Vec3 up = mirrored(wi), h = normalize(wo_ + up);
      return through_ * (Rgb(1.0f) - dielectric_fresnel(dot(wo_, h))) * (ggx_.d(h) * ggx_.g2(wo_, up) / (4 * wo_.z));
    }
    const Vec3 h = upward(normalize(wo_ + eta_ * wi));
    const float wi_h = dot(wi, h), wo_h = dot(wo_, h), denominator = wi_h + wo_h / eta_;
    if (wi_h >= 0 || wo_h <= 0) return {};
    float value = ggx_.d(h) * ggx_.g2(wo_, wi) * std::abs(wi_h * wo_h / (denominator * denominator * wo_.z));
    if (mode == Transport::radiance) value /= eta_ * eta_;
    return through_ * (Rgb(1.0f) - dielectric_fresnel(wo_h)) * value;
  }
  float transmission_pdf(Vec3 wi) const {
    if (through_smooth_) return 0;
    if (m_.thin_walled) {
      const Vec3 h = normalize(wo_ + mirrored(wi));
      return ggx_.visible_d(wo_, h) / (4 * dot(wo_, h));
    }
    const Vec3 h = upward(normalize(wo_ + eta_ * wi));
    const float wi_h = dot(wi, h), wo_h = dot(wo_, h), denominator = wi_h + wo_h / eta_;
    if (wi_h >= 0 || wo_h <= 0) return 0;
    return ggx_.visible_d(wo_, h) * std::abs(wi_h) / (denominator * denominator);
  }

  /// In proportion to estimated albedos.
  void choose_lobes() {
    const float above = over_base(wo_);
    shares_[specular_lobe] =
        above * std::max(0.02f, luminance(smooth_ || inside_ ? fresnel(wo_.z) : specular_albedo()));
    shares_[diffuse_lobe] = above * luminance(diffuse_) * (1 - dielectric_albedo_);
    shares_[transmission_lobe] =
        above * luminance(through_) * (1 - (smooth_ ? luminance(dielectric_fresnel(wo_.z)) : dielectric_albedo_));
    shares_[coat_lobe] = m_.clearcoat * coat_fresnel(wo_.z);
    shares_[sheen_lobe] = has_sheen() ? luminance(m_.sheen_colour) * sheen_albedo(wo_.z, m_.sheen_roughness) : 0;
    float sum = 0;
    for (const float s : shares_) sum += s;
    for (float& s : shares_) s = sum > 0 ? s / sum : 0;
  }

  const GltfPbr& m_;
  Ggx ggx_, coat_ggx_;
  Vec3 wo_{0, 0, 1};
  bool inside_ = false, smooth_ = false, coat_smooth_ = false, through_smooth_ = false;
  float eta_ = 1, alpha_ = 1;
  Rgb f0_, diffuse_, through_;
  float dielectric_albedo_ = 0, mean_albedo_ = 0;
  std::array<float, lobe_count> shares_{};
};

Vec3 in_frame_of(Vec3 wo, Vec3 wi) { return wo.z < 0 ? mirrored(wi) : wi; }

}  // namespace

bool GltfPbr::is_specular() const {
  const bool smooth = Ggx::effectively_smooth(alpha_x, alpha_y);
  const bool has_diffuse = metallic < 1 && transmission < 1 && !is_black(base_colour);
  const bool rough_coat = clearcoat > 0 && !Ggx::effectively_smooth(clearcoat_alpha, clearcoat_alpha);
  return smooth && !has_diffuse && !rough_coat && is_black(sheen_colour);
}

Rgb GltfPbr::eval(Vec3 wo, Vec3 wi, Transport mode) const {
  if (wo.z == 0 || wi.z == 0) return {};
  return View(*this, wo).eval(in_frame_of(wo, wi), mode);
}

float GltfPbr::pdf(Vec3 wo, Vec3 wi) const {
  if (wo.z == 0 || wi.z == 0) return 0;
  return View(*this, wo).pdf(in_frame_of(wo, wi));
}

std::optional<BsdfSample> GltfPbr::sample(Vec3 wo, float u_lobe, Vec2 u, Transport mode) const {
  if (wo.z == 0) return std::nullopt;
  const View view(*this, wo);
  std::size_t lobe = 0;
  while (lobe + 1 < lobe_count && u_lobe >= view.share(static_cast<Lobe>(lobe)))
    u_lobe -= view.share(static_cast<Lobe>(lobe++));
  const auto chosen = static_cast<Lobe>(lobe);
  const auto wi = view.sample_direction(chosen, u);
  if (!wi || wi->z == 0 || !(view.share(chosen) > 0)) return std::nullopt;

  BsdfSample s;
  s.wi = in_frame_of(wo, *wi);
  s.transmitted = chosen == transmission_lobe;
  if (s.transmitted) s.eta = view.eta_through();
  s.specular = (chosen == coat_lobe && view.coat_smooth()) || (chosen == specular_lobe && view.smooth()) ||
               (chosen == transmission_lobe && view.through_smooth());
  if (s.specular) {
    s.weight = view.dirac_weight(chosen, *wi, mode) / view.share(chosen);
    return s;
  }
  s.pdf = view.pdf(*wi);
  if (!(s.pdf > 0)) return std::nullopt;
  s.weight = view.eval(*wi, mode) / s.pdf;
  return s;
}

Rgb GltfPbr::albedo(Vec3 wo) const { return View(*this, wo.z == 0 ? Vec3(0, 0, 1) : wo).albedo(); }

}  // namespace lambert
