#include "lambert/formats/gltf/instancing.h"

#include "lambert/base/number.h"
#include "lambert/formats/gltf/hierarchy.h"

namespace lambert::gltf {

std::vector<Mat4> read_instances(Document& document, const JsonView& json) {
  const JsonView attributes = json["attributes"];
  std::vector<NodePose> poses;
  for (const std::string& name : attributes.keys()) {
    if (name != "TRANSLATION" && name != "ROTATION" && name != "SCALE") {
      document.notes.add("glTF instance attribute " + printable(name) + " is ignored");
      continue;
    }
    const Accessor accessor = document.accessor(attributes[name]);
    document.budget.charge(accessor.count(), sizeof(NodePose) + sizeof(Mat4), attributes[name]);
    if (poses.empty()) poses.resize(accessor.count());
    if (poses.size() != accessor.count())
      attributes[name].fail("has " + std::to_string(accessor.count()) + " elements, but other attributes have " +
                            std::to_string(poses.size()));
    if (name == "ROTATION") {
      const std::vector<Vec4> rotations = accessor.vectors<Vec4>();
      for (std::size_t i = 0; i < poses.size(); ++i) poses[i].rotation = rotation_of(rotations[i]);
    } else {
      const std::vector<Vec3> vectors = accessor.vectors<Vec3>();
      for (std::size_t i = 0; i < poses.size(); ++i)
        (name == "SCALE" ? poses[i].scale : poses[i].translation) = vectors[i];
    }
  }
  std::vector<Mat4> instances;
  instances.reserve(poses.size());
  for (const NodePose& pose : poses) instances.push_back(pose.local());
  return instances;
}

}  // namespace lambert::gltf
