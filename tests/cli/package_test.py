"""cmake --install, then a project outside that finds the package, links it and renders."""
import re
import subprocess

from command_line import BUILD, SOURCE, CommandLineTest, main

PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(user CXX)
find_package(lambert REQUIRED)
add_executable(user user.cpp)
target_link_libraries(user lambert::lambert)
"""
PROGRAM = """
#include "lambert/render/render.h"
#include "lambert/scene/cornell_box.h"
#include <cstdio>
int main() {
  lambert::SceneGraph graph = lambert::cornell_box();
  const lambert::Camera camera = graph.cameras()[0].with_resolution({8, 8});
  const lambert::Scene scene = lambert::compile(std::move(graph));
  const auto method = lambert::make_method("path");
  const auto result = lambert::render(scene, camera, *method, {.samples_per_pixel = 4});
  std::printf("%d samples\\n", static_cast<int>(result.statistics.samples));
}
"""


class Package(CommandLineTest):
    def run_quietly(self, *command):
        done = subprocess.run(list(map(str, command)), cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_installed_package_builds_and_renders(self):
        prefix = self.folder / "prefix"
        self.run_quietly("cmake", "--install", BUILD, "--prefix", prefix)
        self.assertTrue((prefix / "bin" / "lambert").exists())
        (self.folder / "CMakeLists.txt").write_text(PROJECT)
        (self.folder / "user.cpp").write_text(PROGRAM)
        self.run_quietly("cmake", "-S", ".", "-B", "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}")
        self.run_quietly("cmake", "--build", "build")
        self.assertEqual(self.run_quietly("build/user"), "256 samples\n")
        self.the_guides_program_builds(prefix)

    def the_guides_program_builds(self, prefix):
        guide = (SOURCE / "docs" / "guide" / "library.md").read_text()
        folder = self.folder / "turntable"
        folder.mkdir()
        (folder / "CMakeLists.txt").write_text(re.search(r"```cmake\n(.*?)```", guide, re.DOTALL)[1])
        (folder / "turntable.cpp").write_text(re.search(r"```cpp\n(.*?)```", guide, re.DOTALL)[1])
        self.run_quietly("cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}")
        self.run_quietly("cmake", "--build", folder / "build")
        done = subprocess.run([folder / "build" / "turntable", "absent.glb"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("absent.glb", done.stderr)


if __name__ == "__main__":
    main()
