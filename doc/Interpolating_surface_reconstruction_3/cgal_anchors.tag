<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- The anchors of the online CGAL manual that this package refers to, for Doxyfile_standalone.in. -->
<tagfile>
  <compound kind="page">
    <name>thirdparty</name>
    <title>Third Party Dependencies</title>
    <filename>Manual/thirdparty.html</filename>
    <docanchor file="Manual/thirdparty.html">thirdpartyTBB</docanchor>
  </compound>
  <compound kind="page">
    <name>packages</name>
    <title>Package Overview</title>
    <filename>Manual/packages.html</filename>
    <docanchor file="Manual/packages.html">PkgAdvancingFrontSurfaceReconstruction</docanchor>
    <docanchor file="Manual/packages.html">PkgIsosurfacing3</docanchor>
    <docanchor file="Manual/packages.html">PkgMesh3</docanchor>
    <docanchor file="Manual/packages.html">PkgPoissonSurfaceReconstruction3</docanchor>
    <docanchor file="Manual/packages.html">PkgScaleSpaceReconstruction3</docanchor>
  </compound>
  <compound kind="page">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
</tagfile>
