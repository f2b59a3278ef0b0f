sce1.0
eyepos 0 0 5
eyedir 0 0 -1
eyeup 0 1 0
wdist 1
fovy_deg 45
nx 40
ny 30
max_recursion 4
aasample 2
background 0 .1 .2
ca .1 .2 .3
{
rotate 60 1 1 0
translate 1 2 3 # there
scale 1 1 -1.6
pointlight 3 0 4 .8 .8 .6
arealight 0.3 0.8 0.8 0.6
object_flat mesh.obj
object_phong mesh.obj
}
push_matrix
	scale .5 1e-1 -2
	cr 1 0 0
	cp .5 .5 .5
	shininess 30
	ball .5 1 2 3
	cylinder
	triangle 0 0 0 1 0 2 0 1 0
pop_matrix
end
