"""Names of meshes of CGAL's data set, by what they are good for."""

# Closed and connected, of genus 0, from 1,300 to 36,000 triangles.
CLOSED = ["spool.off", "larger_sphere.off", "cube-meshed.off", "sphere966.off", "handle.off", "hand.off", "ellipe0.003.off",
          "blobby.off", "triceratops.off", "cow.off", "retinal.off", "homer.off", "bull.off", "fandisk.off", "camel.off",
          "bear_bis.off", "bear.off", "fandisk_large.off", "man.off"]

# Animals, busts and figures among them, small enough for searches that take long.
FIGURES = ["hand.off", "blobby.off", "triceratops.off", "cow.off", "retinal.off", "homer.off", "bull.off", "camel.off"]

# Closed, connected, with handles.
HANDLES = ["couplingdown.off", "turbine.off", "cheese.off"]

# Whose charts leave little room at a tight bound, with handles and borders among them.
CROWDED = ["anchor.off", "bear_bis.off", "couplingdown.off", "cow.off", "dino.off", "double-torus-example.off", "eight.off",
           "elephant-with-holes.off", "elephant.off", "hand.off", "lion.off", "mpi.off", "mpi_triang.off", "pig.off", "rotor.off",
           "triceratops.off", "turbine.off"]
