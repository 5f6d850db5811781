local equality = 1e-9 -- overloads that differ by no more than this share are equal

local function isOverloaded(entry)
  return alive(entry.object) and entry.overload > 1 and entry.object.fuse and not entry.object.fuse.blown
end

return interaction {
  name = "Electricity <- Fuses",
  text = "In every circuit, blows the fuse that its current overloads most.",
  calls = "Electricity",
  reads = { "electrical_quantities", "fuse" },
  once = true,
  apply = function(world, params, out)
    local entries = world.electrical_quantities.objects
    for _, entry in ipairs(entries) do
      if isOverloaded(entry) then
        local worst = entry.overload
        for _, other in ipairs(entries) do
          if isOverloaded(other) and same(other.circuit, entry.circuit) then
            worst = math.max(worst, other.overload)
          end
        end
        if entry.overload >= (1 - equality) * worst then
          out.blowFuse(entry.object)
        end
      end
    end
  end,
}
