return interaction {
  name = "Dynamics <- Buoyancy",
  text = "Applies F_B to each object at its centre of buoyancy.",
  calls = "Dynamics",
  reads = { "buoyancy_force", "centre_of_buoyancy", "position", "rotation" },
  once = true,
  apply = function(world, params, out)
    local centres = world.centre_of_buoyancy.centres
    for i, entry in ipairs(world.buoyancy_force.forces) do
      local object = entry.object
      if alive(object) and object.position then
        local rotation = object.rotation
        local point = object.position.value + centres[i].centre:turned(rotation and rotation.value or 0)
        out.addForceToPoint(object, point, entry.force)
      end
    end
  end,
}
