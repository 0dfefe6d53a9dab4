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
</tagfile>
