"""Writes meshes as OFF files."""


def write_off(path, points, faces):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        file.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in points)
        file.writelines(" ".join(map(str, (len(face), *face))) + "\n" for face in faces)
