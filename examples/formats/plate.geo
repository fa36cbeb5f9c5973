// A quarter of a plate with a hole, 1 thick; lengths in mm.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 5, 10, 1};
Cylinder(2) = {0, 0, -1, 0, 0, 3, 1};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Mesh.ElementOrder = 2;
Mesh.SecondOrderLinear = 0;
Mesh.MeshSizeMin = 0.6;
Mesh.MeshSizeMax = 2.2;
Mesh.MeshSizeFromCurvature = 10;
Physical Volume("SOLID") = {3};
