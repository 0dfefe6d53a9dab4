<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<tagfile>
  <compound kind="page">
    <name>smc_cgal_links</name>
    <title>CGAL</title>
    <filename>Manual/index.html</filename>
    <docanchor file="BGL/group__bgl__namedparameters.html" title="Named Parameters">bgl_namedparameters</docanchor>
    <docanchor file="Manual/license.html" title="GPL">licensesGPL</docanchor>
    <docanchor file="Manual/license.html" title="LGPL">licensesLGPL</docanchor>
    <docanchor file="Manual/packages.html" title="CGAL and the Boost Graph Library">PkgBGL</docanchor>
    <docanchor file="Manual/packages.html" title="Triangulated Surface Mesh Parameterization">PkgSurfaceMeshParameterization</docanchor>
  </compound>
  <compound kind="class">
    <name>FaceGraph</name>
    <filename>BGL/classFaceGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceListGraph</name>
    <filename>BGL/classFaceListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>HalfedgeGraph</name>
    <filename>BGL/classHalfedgeGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>HalfedgeListGraph</name>
    <filename>BGL/classHalfedgeListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>VertexListGraph</name>
    <filename>BGL/classVertexListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>EdgeListGraph</name>
    <filename>BGL/classEdgeListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>Parameterizer_3</name>
    <filename>Surface_mesh_parameterization/classParameterizer__3.html</filename>
  </compound>
  <compound kind="class">
    <name>SparseLinearAlgebraWithFactorTraits_d</name>
    <filename>Solver_interface/classSparseLinearAlgebraWithFactorTraits__d.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Surface_mesh</name>
    <filename>Surface_mesh/classCGAL_1_1Surface__mesh.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Polyhedron_3</name>
    <filename>Polyhedron/classCGAL_1_1Polyhedron__3.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Seam_mesh</name>
    <filename>BGL/classCGAL_1_1Seam__mesh.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Sequential_tag</name>
    <filename>STL_Extension/structCGAL_1_1Sequential__tag.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Parallel_tag</name>
    <filename>STL_Extension/structCGAL_1_1Parallel__tag.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Exact_predicates_inexact_constructions_kernel</name>
    <filename>Kernel_23/classCGAL_1_1Exact__predicates__inexact__constructions__kernel.html</filename>
  </compound>
</tagfile>
