#pragma once
#include "lambert/bsdf/bsdf.h"
#include "lambert/bsdf/coated_conductor.h"
#include "lambert/bsdf/coated_diffuse.h"
#include "lambert/bsdf/conductor.h"
#include "lambert/bsdf/dielectric.h"
#include "lambert/bsdf/diffuse.h"
#include "lambert/bsdf/diffuse_transmission.h"
#include "lambert/bsdf/gltf_pbr.h"
#include "lambert/bsdf/thin_dielectric.h"

#include <type_traits>
#include <utility>
#include <variant>

namespace lambert {

/// A variant whose alternatives must all be models: a forgotten function is a compile error that names the type.
template <BsdfModel... Models>
using BsdfVariant = std::variant<Models...>;

/// The closed set of scattering models. CONTRIBUTING says how to add one.
class Bsdf {
 public:
  using Model = BsdfVariant<Diffuse, Conductor, Dielectric, ThinDielectric, CoatedDiffuse, CoatedConductor,
                            DiffuseTransmission, GltfPbr>;
  Bsdf() = default;
  template <BsdfModel M>
  Bsdf(M model) : model_(std::move(model)) {}

  Rgb eval(Vec3 wo, Vec3 wi, Transport mode = Transport::radiance) const {
    return dispatch([&](const auto& m) { return m.eval(wo, wi, mode); });
  }
  float pdf(Vec3 wo, Vec3 wi) const {
    return dispatch([&](const auto& m) { return m.pdf(wo, wi); });
  }
  std::optional<BsdfSample> sample(Vec3 wo, float u_lobe, Vec2 u, Transport mode = Transport::radiance) const {
    return dispatch([&](const auto& m) { return m.sample(wo, u_lobe, u, mode); });
  }
  Rgb albedo(Vec3 wo) const {
    return dispatch([&](const auto& m) { return m.albedo(wo); });
  }
  bool is_specular() const {
    return dispatch([](const auto& m) { return m.is_specular(); });
  }
  const Model& model() const { return model_; }

 private:
  /// Most surfaces are diffuse: the compiler sees their functions through this branch, and inlines them.
  template <class F>
  std::invoke_result_t<F, const Diffuse&> dispatch(const F& f) const {
    if (const auto* diffuse = std::get_if<Diffuse>(&model_)) return f(*diffuse);
    return std::visit(f, model_);
  }

  Model model_;
};

}  // namespace lambert
