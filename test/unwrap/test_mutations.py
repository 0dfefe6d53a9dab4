"""Small files with random damage: any answer but a crash or a hang will do."""

import random

from support import (Case, colored_off, decorated_obj, decorated_ply, main, sphere, to_binary_stl, to_glb, to_obj, to_off,
                     to_ply, to_text_stl, torus)

SEED = 20260101
MUTATIONS_PER_FILE = 60
SPHERE = sphere(1)
FILES = {"a.off": to_off(SPHERE).encode(), "a.obj": to_obj(SPHERE).encode(),
         "a.ply": to_ply(SPHERE, "ascii"), "b.ply": to_ply(SPHERE, "binary_little_endian"),
         "a.stl": to_text_stl(SPHERE).encode(), "b.stl": to_binary_stl(SPHERE)}
COLORED = {"colored.off": colored_off(SPHERE).encode()}
DECORATED = {"decorated.obj": decorated_obj(SPHERE).encode(), "decorated.ply": decorated_ply(SPHERE).encode()}

QUADS = torus(4)[0], [tuple(one) + (two[2],) for one, two in zip(torus(4)[1][::2], torus(4)[1][1::2])]
POLYGONS = {"quads.off": to_off(QUADS).encode(), "quads.ply": to_ply(QUADS, "binary_big_endian"), "a.glb": to_glb(*SPHERE)}


def mutate(data, generator):
    data = bytearray(data)
    for _ in range(generator.choice((1, 1, 2, 5))):
        place = generator.randrange(len(data))
        kind = generator.randrange(4)
        if kind == 0:
            data[place] = generator.randrange(256)
        elif kind == 1:
            data[place] = generator.choice(b"0123456789-.e \n")
        elif kind == 2:
            del data[place:place + generator.choice((1, 2, 20))]
        else:
            data[place:place] = data[place:place + generator.choice((1, 4, 50))]
    return bytes(data)


class Mutations(Case):
    def mutate_all(self, files, seed, *options, output="out.obj"):
        print(f"seed {seed}")
        generator = random.Random(seed)
        for name, data in files.items():
            for number in range(MUTATIONS_PER_FILE):
                with self.subTest(name=name, number=number):
                    self.write(name, mutate(data, generator))
                    exit_code, report = self.report(name, "-o", output, "--threads", "1", *options)
                    self.assertIn(exit_code, (0, 3, 4, 5), report["message"])
                    self.assertEqual(output in self.files(), exit_code == 0)
                    (self.folder / output).unlink(missing_ok=True)

    def test_mutations(self):
        self.mutate_all(FILES, SEED)

    def test_mutations_of_polygons(self):
        self.mutate_all(POLYGONS, SEED, output="out.ply")
        self.mutate_all(POLYGONS, SEED + 1, output="out.glb")

    def test_mutations_of_colors(self):
        self.mutate_all(COLORED, SEED, "--edge-weights", "colors")

    def test_mutations_of_texture_coordinates(self):
        self.mutate_all(DECORATED, SEED, "--initial-cut", "uv", "--edge-weights", "colors")


main()
