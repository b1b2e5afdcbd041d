// The scene of from_pov_ray.md; still.lua beside it is the same.
#version 3.7;
global_settings { assumed_gamma 1.0 ambient_light rgb 1 max_trace_level 16 }
background { rgb <0.35, 0.45, 0.60> }
camera { location <0, 2.2, -7> look_at <0, 0.8, 0> angle 50 }
light_source { <-5, 8, -6> rgb 0.9 area_light <1.4,0,0>, <0,1.4,0>, 9, 9 circular orient adaptive 1 jitter }
light_source { <6, 3, -4> rgb 0.8 fade_distance 5 fade_power 2 }

#declare Matt = finish { ambient 0.2 diffuse 0.8 }
plane { y, 0 pigment { rgb <0.7, 0.68, 0.62> } finish { Matt } }
sphere { 0, 1 scale <0.8, 1.1, 0.8> translate <-2, 1.1, 0.5>
  pigment { rgb <0.8, 0.25, 0.15> } finish { Matt phong 0.5 phong_size 40 } }
box { <-0.6, 0, -0.6>, <0.6, 1.4, 0.6> rotate <0, 30, 0> translate <0.1, 0, 1.6>
  pigment { rgb <0.2, 0.35, 0.7> } finish { ambient 0.2 diffuse 0.5 reflection 0.4 } }
cone { <2, 0, 0>, 0.7, <2, 1.8, 0>, 0 pigment { rgb <0.85, 0.65, 0.2> } finish { Matt } }
torus { 0.6, 0.2 rotate <70, 0, 0> rotate <0, -25, 0> translate <-0.6, 0.65, -1.2>
  pigment { rgb <0.3, 0.6, 0.35> } finish { Matt } }
sphere { <0.9, 0.7, -1.4>, 0.7 pigment { rgbt <1, 1, 1, 1> } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
  interior { ior 1.5 fade_color <0.9, 0.6, 0.3> fade_distance 0.5 fade_power 1001 } }
