# Faults of drawings, common to all controls.

FC-1001 = Çizim yarıda bitiyor
    .help = Çizimi yeniden kaydedin ya da aktarın.

FC-1002 = Çizimde alınabilecek olandan çok şey var
    .detail = en çok { $megabytes } MB
    .detail-2 = en çok { $curves } doğru ve yay
    .detail-3 = en çok { $points } eğri noktası
    .detail-4 = en çok { $inserts } yerleştirilmiş blok
    .help = Çizimi bölün ya da toleransı büyütün.

FC-1003 = Çizimde kesilecek bir şey yok
    .help = Çizimde doğru ya da eğri olup olmadığına ve hangi katmanlarda olduklarına bakın.

FC-1004 = Çizimin bir yeri sıfırından çok uzakta
    .detail = { $position } mm, en çok { $limit }
    .help = Çizimin birimini ve ölçeğini denetleyin.

FC-1005 = Burada bir DXF grup kodu yok
    .detail = { $word }
    .help = Çizimi yeniden ASCII DXF dosyası olarak kaydedin.

FC-1006 = Bir DXF değeri kullanılabilecek bir sayı değil
    .detail = { $word }
    .help = Çizimi yeniden ASCII DXF dosyası olarak kaydedin.

FC-1007 = DXF dosyası ikili biçimde
    .help = Çizimi ASCII DXF dosyası olarak kaydedin.

FC-1008 = Çizimdeki nesne okunamıyor
    .detail = { $word }
    .help = Nesneyi silin ya da çizimi yeniden kaydedin.

FC-1009 = Çizimin bir bloğu kendini içeriyor
    .detail = { $name }
    .help = Bloğun içinden kendi yerleştirmesini silin.

FC-1010 = Spline'ın derecesi, düğümleri, ağırlıkları ve noktaları birbirine uymuyor
    .help = Spline'ı yeniden çizin ya da çoklu çizgiye dönüştürün.

FC-1011 = Burada bir PLT komutu yok
    .detail = { $word }
    .help = Dosyanın PLT (HP-GL) metni olduğunu ve eksiksiz aktarıldığını denetleyin.

FC-1012 = PLT komutunun değer sayısı yanlış
    .detail = { $word }
    .help = Komutu denetleyin; üç boyutlu dosyada bir noktanın üç değeri olur (dims = 3).

FC-1013 = Kesilmeyen türdeki nesneler alınmadı
    .detail = { $kind }, { $count }
    .help = Kesileceklerse doğru, yay ya da çoklu çizgiye dönüştürün.

FC-1014 = Gösterilmeyen bir katmandaki nesneler alınmadı
    .detail = { $name }, { $count }
    .help = Kesileceklerse katmanı çözün ya da açın.

FC-1015 = Kâğıt uzayındaki ve görünmez nesneler alınmadı
    .detail = { $count }
    .help = Kesileceklerse model uzayına taşıyın.

FC-1016 = Yerleştirilmiş bir blok çizimde yok
    .detail = { $name }
    .help = Çizimi bütün bloklarıyla yeniden kaydedin.

FC-1017 = Bir PLT komutu yürütülmüyor
    .detail = { $instruction }
    .help = Bir şey, örneğin harf çiziyorsa o eksiktir: görüntüyü çizimle karşılaştırın.

FC-1018 = İçe aktarma ayarı kullanılamıyor
    .detail = { $setting }: { $value }; izin verilen: { $allowed }
    .help = Ayarı import komutunun yardımında anlatıldığı gibi verin.

FC-1019 = Çizimler bu kontrolün program dilinde yazılamaz
    .detail = { $name }
    .help = gsk990mc, kaitong ya da weihong kullanın.

FC-1020 = Dosya ne PLT ne DXF çizimi
    .detail = { $file }
    .help = Bunlardan biriyse türünü --from plt ya da --from dxf ile belirtin.

FC-1021 = Çizimde bu katmanda ya da bu kalemle bir şey yok
    .detail = { $name }; çizimde olanlar: { $names }
    .help = Çizimde bulunan bir ad kullanın. Katmanlar DXF, kalemler PLT çizimleri içindir.

FC-1022 = PLT komutu burada bilinmiyor
    .detail = { $instruction }
    .help = Komutu çıkarın ya da çizimi yalnızca doğru ve yaylarla kaydedin: PU, PD, PA, PR, AA, AR, CI, EA, ER ve EW.
