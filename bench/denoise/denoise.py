"""Error of the denoisers against converged references: prints a table, and a plot of error over samples with --plot FILE.svg.

    python3 bench/denoise/denoise.py build/release/bin/lambert [--spp 4,16,64] [--reference 2048] [--plot error.svg]
"""
import argparse
import array
import pathlib
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import svg_plot
import boxes

METHODS = ("nfor", "nlm", "bilateral")


def pixels(path):
    data = path.read_bytes().split(b"\n", 3)
    width, height = map(int, data[1].split())
    values = array.array("f")
    values.frombytes(data[3][:width * height * 12])
    return values


def errors(image, truth):
    """MSE, and relMSE with 0.01 added to the squared mean of the reference's channels."""
    mse = rel = 0.0
    for i in range(0, len(truth), 3):
        level = sum(truth[i:i + 3]) / 3
        squared = sum((image[i + c] - truth[i + c]) ** 2 for c in range(3))
        mse += squared
        rel += squared / (level * level + 0.01)
    return mse / len(truth), rel / len(truth)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--spp", default="16")
    parser.add_argument("--reference", type=int, default=2048)
    parser.add_argument("--size", default="192x192")
    parser.add_argument("--plot")
    o = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scenes = {"box": [], **{k: [v] for k, v in boxes.write(folder).items()}}
        curves = {m: [] for m in ("noisy", *METHODS)}
        run = lambda *words: subprocess.run([o.program, *map(str, words)], check=True, stdout=subprocess.DEVNULL)
        print(f"{'scene':10} {'spp':>5} {'method':10} {'MSE':>10} {'less':>7} {'relMSE':>10} {'less':>7} {'CPU s':>7}")
        for scene, words in scenes.items():
            shot = ["render", *words, "--resolution", o.size, "--quiet"]
            run(*shot, "--spp", o.reference, "--seed", 1, "-o", folder / "truth.pfm")
            truth = pixels(folder / "truth.pfm")
            for spp in map(int, o.spp.split(",")):
                run(*shot, "--spp", spp, "--seed", 7, "--aov", "denoising", "-o", folder / "n.exr", "-o", folder / "noisy.pfm")
                noisy = errors(pixels(folder / "noisy.pfm"), truth)
                for method in ("noisy", *METHODS):
                    before = resource.getrusage(resource.RUSAGE_CHILDREN)
                    if method != "noisy":
                        run("denoise", folder / "n.exr", "--method", method, "-o", folder / f"{method}.pfm")
                    after = resource.getrusage(resource.RUSAGE_CHILDREN)
                    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
                    mse, rel = errors(pixels(folder / f"{method}.pfm"), truth)
                    print(f"{scene:10} {spp:5} {method:10} {mse:10.3g} {noisy[0] / mse:6.1f}x {rel:10.3g} {noisy[1] / rel:6.1f}x "
                          f"{seconds:7.2f}", flush=True)
                    if scene == "box":
                        curves[method].append((spp, mse))
        if o.plot:
            pathlib.Path(o.plot).write_text(svg_plot.log_lines("The Cornell box: mean squared error", "samples per pixel", "MSE", curves))


main()
