return interaction {
  name = "Dynamics <- Liquid Drag",
  text = "Lets liquids resist the motion of what is in them, and carry it along where they flow; says how fast F_B "
    .. "varies.",
  calls = "Dynamics",
  reads = { "liquid_resistance" },
  once = true,
  apply = function(world, params, out)
    local foreseen = world.liquid_resistance.foreseen
    for _, e in ipairs(world.liquid_resistance.entries) do
      if alive(e.object) then
        out.addDrag(e.object, e.point, e.xx, e.xy, e.yy, e.angular)
        if e.rate > 0 then
          out.tellRate(e.object, e.rate, foreseen, not foreseen)
        end
        if e.push ~= vec2(0, 0) then
          out.addForceToPoint(e.object, e.point, e.push)
        end
      end
    end
  end,
}
