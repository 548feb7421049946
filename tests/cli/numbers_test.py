"""Numbers that a flag does not have are refused with what was expected, before any work."""
from command_line import CommandLineTest, main

RING = "0 0\n4 0\n4 3\n"

# A command, and for a flag: numbers that it does not have, and what it expects.
REFUSED = [
    ("polygon trapezoids a.txt --seed", "-1 inf 1e20", "a whole number from 0 to 18446744073709551615"),
    ("hdr expose a.pfm -o b.png --seed", "-1", "a whole number from 0 to 18446744073709551615"),
    ("lab comb --seed", "-1 nan", "a whole number from 0 to 18446744073709551615"),
    ("render --seed", "-1 18446744073709551616", "a whole number from 0 to 18446744073709551615"),
    ("polygon extrude a.txt --crease", "nan inf -1 181", "an angle from 0 to 180 degrees"),
    ("polygon revolve a.txt --crease", "nan -0.5", "an angle from 0 to 180 degrees"),
    ("polygon revolve a.txt --sweep", "nan 0 361 -90", "an angle above 0 and at most 360 degrees"),
    ("polygon revolve a.txt --start", "nan inf 361", "an angle from -360 to 360 degrees"),
    ("polygon revolve a.txt --steps", "0 -1 1e9", "a whole number from 1 to 16777216"),
    ("polygon pick a.txt --at 1,1 --radius", "inf nan 0 -2", "a finite number above 0"),
    ("polygon pick a.txt --at 1,1 --width", "inf nan 0", "a finite number above 0"),
    ("image convert a.pfm -o b.png --exposure", "nan inf 1001", "a number of stops from -1000 to 1000"),
    ("image convert a.pfm -o b.jpg --quality", "0 101 nan", "a whole number from 1 to 100"),
    ("image resize a.pfm -o b.png --scale", "nan inf 0 -1", "a ratio above 0"),
    ("hdr merge a.png -o b.exr --scale", "nan inf 0 1e300", "a number from 1e-30 to 1e30"),
    ("denoise a.pfm -o b.pfm --firefly", "nan inf -1 1e300", "a number from 0 to 1e30"),
    ("probe irradiance a.pfm --normal", "nan,0,0 0,0,0 1,inf,0", "three finite numbers that are not all 0"),
    ("probe check a.pfm --irradiance 1 --normal", "nan,0,0 0,0,0", "three finite numbers that are not all 0"),
]
REFUSED_BY_COMPARE = [
    ("compare a.pfm a.pfm --fail", "nan inf", "a finite number"),
    ("compare a.pfm a.pfm --warn-percent", "nan -1 101", "a number from 0 to 100"),
    ("compare a.pfm a.pfm --hard-fail", "nan -1", "a number, 0 or more"),
    ("compare a.pfm a.pfm --heat-top", "nan -1 inf", "a number, 0 or more"),
]


class Numbers(CommandLineTest):
    def setUp(self):
        super().setUp()
        (self.folder / "a.txt").write_text(RING)
        (self.folder / "a.pfm").write_bytes(b"PF\n1 1\n-1\n" + bytes(12))

    def refused(self, table, status):
        for command, numbers, expected in table:
            for number in numbers.split():
                with self.subTest(command + " " + number):
                    flag = command.split()[-1]
                    done = self.lambert(*command.split()[:-1], f"{flag}={number}", status=status)
                    self.assertIn(f"{flag}: expected {expected}", done.stderr)
                    self.assertIn(f"got '{number}'", done.stderr)
                    self.assertEqual(self.files(), ["a.pfm", "a.txt"])

    def test_out_of_range(self):
        self.refused(REFUSED, 1)

    def test_out_of_range_of_compare(self):
        self.refused(REFUSED_BY_COMPARE, 4)

    def test_ends_of_the_ranges(self):
        for command in ("polygon trapezoids a.txt --seed 18446744073709551615", "polygon extrude a.txt --crease 180",
                        "polygon revolve a.txt --sweep 360 --start -360 --crease 0", "polygon pick a.txt --at 1,1 --radius 1e300",
                        "compare a.pfm a.pfm --fail-percent 100 --hard-warn 0", "image convert a.pfm -o b.jpg --quality 100"):
            with self.subTest(command):
                self.lambert(*command.split())


if __name__ == "__main__":
    main()
